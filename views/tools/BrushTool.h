// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/BrushGesture.h"
#include "views/tools/StrokePlane.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <cstdint>
#include <memory>
#include <vector>

namespace espalier {

/// The brush (TreeSketch §3.2): fills a ball with markers of free space, which the tree grows into. It moves
/// in the plane that is parallel to the screen and goes through the base of the tree, or through the branch
/// at which the stroke begins. The plane turns with the camera, so that a pointer at rest draws a helix while
/// the view rotates. StrokePlane has other planes, and strokes around the trunk.
///
/// A second tap on a branch prunes it; a finger or pen that rests on a bud chooses that bud to grow alone. A
/// drag with the Shift key to the right or to the left makes the brush larger or smaller where it is.
class BrushTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(BrushTool)

public:
    using Tool::Tool;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    void tick(double now) override;
    void wheel(double notches) override;

    bool isFreehand() const override { return !m_sizing; }
    bool isActive() const override
    {
        return m_gesture != nullptr || m_held.has_value() || m_sizing.has_value();
    }
    bool wantsTicks() const override { return isActive(); }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// Share of the brush's radius for a pen's pressure (0...1): a light touch draws a small ball, a firm one
    /// the full size.
    static double radiusShare(double pressure);

private:
    /// A press that is not yet a stroke: it may become a long press on a bud.
    struct Hold {
        PointerSample sample;
        PickedBud bud;
        bool isChosen = false; ///< The press has become a long press
    };
    /// A drag that changes the radius.
    struct Sizing {
        QPointF from;        ///< px
        double radius = 0.0; ///< Before the drag, m
    };
    struct Tap {
        QPointF position;
        double time = -1e9;       ///< Time of the tap, s
        bool leftAStroke = false; ///< Whether the tap left a stroke on the undo stack
    };

    void resizeTo(const QPointF& pointer);
    bool pruneOnSecondTap(const PointerSample& sample);
    void beginStroke(const PointerSample& sample);
    BrushSample sampleAt(double time) const;
    double strokeTime(double time) const;
    void continueTo(double time);
    void rest(double now);
    void paintReason(Overlay& overlay) const;
    void stop();
    std::vector<Vec3> shownBrushes(const Vec3& centre) const;

    std::unique_ptr<BrushGesture> m_gesture;
    StrokePlane m_plane;
    QPointF m_pointer;
    double m_pressure = 1.0;
    bool m_isPen = false;
    bool m_hovers = false;
    std::optional<PickedBranch> m_picked; ///< The branch under the hovering pointer
    double m_begun = 0.0;                 ///< Beginning of the stroke, s, of the samples' clock
    std::vector<Vec3> m_trail;
    std::optional<Hold> m_held;
    std::optional<Sizing> m_sizing;
    PointerSample m_press;          ///< First sample of the gesture under way
    int m_undoIndex = 0;            ///< Index of the undo stack at that sample
    std::uint32_t m_sizeBefore = 0; ///< Of the tree at that sample
    double m_now = 0.0;             ///< Time of the last tick, s
    Tap m_lastTap;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/WidthGesture.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <memory>
#include <optional>

namespace espalier {

/// Gives branches the width that a person wants (TreeSketch §3.3). A tap on a branch holds it at the width
/// that it has; a handle across it, with two ends, is drawn to another width or moved along the branch.
class WidthTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(WidthTool)

public:
    using Tool::Tool;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    bool keyPressed(int key) override;

    bool isActive() const override { return m_isDown; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// How far beyond the bark a handle's ends are, px.
    static constexpr double kBeyond = 12.0;
    /// An end that is drawn this near to the axis removes the width, px.
    static constexpr double kVanishing = 4.0;

private:
    enum class Part {
        Middle,
        End,
        Bark, ///< Where no handle was before
    };
    struct Grip {
        InternodeId id;
        Part part;
    };
    /// Where a handle is seen.
    struct Place {
        Vec3 centre;        ///< On the bark, m
        Vec3 across;        ///< Unit, parallel to the screen
        QPointF seen;       ///< The centre, px
        QPointF seenAcross; ///< Unit
        double pixelsPerMetre;
    };

    std::optional<Place> placeOf(InternodeId id) const;
    std::optional<Grip> gripAt(const PointerSample& sample) const;
    std::optional<InternodeId> branchAt(const PointerSample& sample) const;
    double diameterOf(InternodeId id) const;
    InternodeId nearestOnAxis(const QPointF& position) const;
    void stop();
    void paintHandle(Overlay& overlay, InternodeId id, bool isLit, bool isLabelled) const;

    std::optional<Grip> m_hovered; ///< A handle
    std::optional<InternodeId> m_hoveredBranch;
    std::optional<InternodeId> m_chosen; ///< Whose handle was touched last
    bool m_isDown = false;
    std::optional<Grip> m_grip; ///< That a pointer holds
    std::unique_ptr<WidthGesture> m_gesture;
    bool m_isPulled = false; ///< Too far for a tap
    QPointF m_pressedAt;
    double m_distance = 0.0; ///< From the axis, where it was gripped, px
    double m_diameter = 0.0; ///< Of the branch then, m
    InternodeId m_place = 0; ///< Where the handle in the hand is now
    double m_tapTime = -1e9; ///< s, of the last tap on a handle
};

} // namespace espalier

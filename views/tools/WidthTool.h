// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/WidthGesture.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <memory>
#include <optional>

namespace espalier {

/// Sets the width of branches (TreeSketch §3.3). A tap on a branch fixes its current width; a handle across
/// the branch, with two ends, is dragged to another width or moved along the branch. A tap on its number
/// opens a field to type another one.
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
    void forget() override;
    void renumber(const NewNumbers& internodes) override;

    bool isActive() const override { return m_isDown; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// Distance of a handle's ends from the bark, px.
    static constexpr double kBeyond = 12.0;
    /// An end that is dragged this near to the axis removes the width, px.
    static constexpr double kVanishing = 4.0;

private:
    enum class Part {
        Middle,
        End,
        Bark, ///< A place without a handle
    };
    struct Grip {
        InternodeId id;
        Part part;
    };
    /// A handle's place on the screen.
    struct Place {
        Vec3 centre;        ///< On the bark, m
        Vec3 across;        ///< Unit, parallel to the screen
        QPointF seen;       ///< Place of the centre on the screen, px
        QPointF seenAcross; ///< Direction across on the screen, unit
        double pixelsPerMetre;
    };

    std::optional<Place> placeOf(InternodeId id) const;
    std::optional<Grip> gripAt(const PointerSample& sample) const;
    std::optional<InternodeId> branchAt(const PointerSample& sample) const;
    double diameterOf(InternodeId id) const;
    InternodeId nearestOnAxis(const QPointF& position) const;
    void stop();
    void type(InternodeId id);
    void paintHandle(Overlay& overlay, InternodeId id, bool isLit, bool isLabelled) const;

    std::optional<Grip> m_hovered; ///< The handle under the pointer
    std::optional<InternodeId> m_hoveredBranch;
    std::optional<InternodeId> m_chosen; ///< The internode whose handle was touched last
    bool m_isDown = false;
    std::optional<InternodeId> m_labelled; ///< The one whose label the pointer pressed
    std::optional<Grip> m_grip;            ///< The handle that a pointer holds
    std::unique_ptr<WidthGesture> m_gesture;
    bool m_isPulled = false; ///< The pointer has moved too far for a tap
    QPointF m_pressedAt;
    double m_distance = 0.0; ///< Distance from the axis at the press, px
    double m_diameter = 0.0; ///< Diameter of the branch at the press, m
    InternodeId m_place = 0; ///< Current place of the dragged handle
    double m_tapTime = -1e9; ///< s, of the last tap on a handle
};

} // namespace espalier

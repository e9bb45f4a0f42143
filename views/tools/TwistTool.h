// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/TwistGesture.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <memory>
#include <optional>

namespace espalier {

/// Twists the strands of branches (Strands 2024 §5.4). A drag on a branch, along it or around it, turns the
/// strands from the pressed internode on up to the branch's tip, the same angle at each node; around the
/// branch, the bark follows the pointer. With Shift, or by a choice in the tool's pop-out, all that the
/// branch carries is twisted as well. A second tap takes the twist away.
class TwistTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(TwistTool)

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
    QCursor cursor() const override { return Qt::OpenHandCursor; }
    QString tip() const override;

    /// Degrees from node to node for a pixel of the drag.
    static constexpr double kDegreesPerPixel = 0.2;

private:
    TwistScope scopeOf(const PointerSample& sample) const;
    std::optional<InternodeId> internodeAt(const PointerSample& sample) const;
    double twistOf(InternodeId id) const;
    void stop();
    void paintStrands(Overlay& overlay, InternodeId id) const;

    bool m_isDown = false;
    bool m_isPulled = false;
    bool m_isAround = false; ///< The drag goes around the branch
    std::unique_ptr<TwistGesture> m_gesture;
    InternodeId m_id = 0; ///< Of the gesture, or of the last tap
    TwistScope m_scope = TwistScope::Branch;
    double m_from = 0.0; ///< Twist before the drag, degrees
    QPointF m_pressedAt;
    QPointF m_at;     ///< Of the pointer, px
    QPointF m_upward; ///< The branch's direction on the screen at the press, of unit length
    double m_tapTime = -1e9;
    std::optional<InternodeId> m_hovered;
};

} // namespace espalier

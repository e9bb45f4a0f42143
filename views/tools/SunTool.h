// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <optional>

namespace espalier {

/// Moves the sun (TreeSketch §3.5): a ball that moves around the tree on a sphere that fills the view, in
/// front of the tree or behind it. When it is dragged beyond the sphere's rim, it moves to the other side. A
/// held sun stays under the pointer while the view turns. The sun is part of the view, so its moves are not
/// undone.
class SunTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(SunTool)

public:
    using Tool::Tool;

    /// Whether a pointer at @p screen is at most @p reach px from the ball.
    bool isAt(const QPointF& screen, double reach) const;
    /// Place of the ball on the screen, px.
    QPointF place() const;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    void tick(double now) override;
    bool isActive() const override { return m_grip.has_value(); }
    bool wantsTicks() const override { return isActive(); }
    void paint(Overlay& overlay) const override;
    QCursor cursor() const override { return Qt::OpenHandCursor; }
    QString tip() const override;

private:
    /// How it is held.
    struct Grip {
        QPointF offset; ///< From the pointer to the ball, px
        bool isBehind = false;
        ViewValues before;
    };

    void follow();

    std::optional<Grip> m_grip;
    QPointF m_pointer;
    bool m_isUnderPointer = false;
};

} // namespace espalier

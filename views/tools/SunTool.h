// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <optional>

namespace espalier {

/// Moves the sun (TreeSketch §3.5): a ball that goes about the tree on a sphere that fills the view, before
/// it or behind it. Beyond the sphere's rim it comes to the other side. A held sun stays under the pointer
/// while the tree is turned. It is part of the view, so nothing of this is undone.
class SunTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(SunTool)

public:
    using Tool::Tool;

    /// Whether a pointer at @p screen, which reaches @p reach px, is on the ball.
    bool isAt(const QPointF& screen, double reach) const;
    /// Where the ball is seen, px.
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

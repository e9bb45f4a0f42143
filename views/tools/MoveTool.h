// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/MoveBranch.h"
#include "model/sketch/BranchAxis.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <functional>
#include <memory>
#include <optional>

namespace espalier {

/// Moves branches with all that they carry. A branch that is held at its middle slides along the wood that it
/// stands on, and goes around it; one that is held near its base goes to other wood; one that is held near
/// its tip becomes longer or shorter, and what it carries larger or smaller. In a drawing without depth, a
/// branch stays in the plane: it goes around the wood to the other side at once.
class MoveTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(MoveTool)

public:
    /// @p refused is told why a branch does not move.
    MoveTool(ToolContext& context, std::function<void(const QString& why)> refused)
        : Tool(context), m_refused(std::move(refused))
    {
    }

    void begin(const PointerSample& sample) override;
    void move(const PointerSample& sample) override;
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    void tick(double now) override;

    bool isActive() const override { return m_isDown; }
    bool wantsTicks() const override { return m_isDown; }
    void paint(Overlay& overlay) const override;
    QCursor cursor() const override { return Qt::OpenHandCursor; }
    QString tip() const override;

private:
    enum class Part { Base, Middle, Tip };
    /// The branch under the pointer.
    struct Held {
        InternodeId axis = 0;
        Part part = Part::Middle;
        Vec3 grip = Vec3::Zero();   ///< The place that is held, m
        std::uint64_t revision = 0; ///< Of the document
    };
    /// Where a branch was when the drag began.
    struct Start {
        BranchAxis parent;
        BranchPlace place;
        double distance;   ///< Of its base on the parent's axis, m
        Vec3 base;         ///< m
        Vec3 heading;      ///< Of the internode that it stands on
        Rotation rotation; ///< Of its first internode, in the world
        Rotation local;    ///< The same in the frame of what it stands on
        InternodeId end;   ///< Number of internodes
        bool isFlat;       ///< The tree has no depth
    };

    std::optional<Held> heldAt(const PointerSample& sample) const;
    void grip();
    void pull();
    BranchMove slid() const;
    BranchMove reattached() const;
    BranchMove scaled() const;
    BranchMove placedAt(const BranchPlace& place, const Rotation& rotation) const;
    double turnAround() const;
    bool carries(InternodeId first, InternodeId id) const;

    std::function<void(const QString& why)> m_refused;
    std::optional<Held> m_held;
    std::optional<Start> m_start;
    std::unique_ptr<MoveGesture> m_gesture;
    bool m_isDown = false;
    bool m_isSettled = true;
    QPointF m_pressed;
    QPointF m_pointer;
    double m_slip = 0.0; ///< px
};

} // namespace espalier

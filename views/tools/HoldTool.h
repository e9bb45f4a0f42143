// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/HoldGesture.h"
#include "views/tools/Tool.h"

#include <memory>

namespace espalier {

/// A tool that changes a branch as long as it is pressed: the branch answers while the pointer is down, and
/// the release ends one undo step. Rings around the branch show the time held.
class HoldTool : public Tool {
public:
    using Tool::Tool;

    void begin(const PointerSample& sample) override;
    void move(const PointerSample&) override {}
    void end(const PointerSample& sample) override;
    void finish() override;
    void cancel() override;
    void hover(const PointerSample& sample) override;
    void leave() override;
    void tick(double now) override;

    bool isActive() const override { return m_gesture != nullptr; }
    bool wantsTicks() const override { return isActive(); }
    void paint(Overlay& overlay) const override;
    QCursor cursor() const override { return Qt::PointingHandCursor; }

private:
    virtual std::unique_ptr<HoldGesture> makeGesture(TreeDocument& document, InternodeId branch) const = 0;
    virtual QColor ringColour() const = 0;
    /// Whether the rings go outward while the branch is held, or inward.
    virtual bool ringsGrow() const = 0;

    void aim(const PointerSample& sample);
    void stop();

    std::unique_ptr<HoldGesture> m_gesture;
    std::optional<PickedBranch> m_picked; ///< The branch that is held, or under the hovering pointer
    double m_lastTime = 0.0;              ///< s, of the samples' clock
    double m_heldTime = 0.0;              ///< s of the gesture's own time
};

} // namespace espalier

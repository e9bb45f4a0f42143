// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/BranchPropagation.h"
#include "views/tools/Tool.h"

#include <QCoreApplication>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// More by example (Okabe 2005, 3.4 and 3.6): a tap on a branch gives it one more branch like those that it
/// carries. With ViewValues::passesOn, a tap gives other branches what that branch carries, and a drag from
/// it across others gives it to these alone. The branch under the pointer shows, and in thin lines what would
/// come of it.
class MultiplyTool : public Tool {
    Q_DECLARE_TR_FUNCTIONS(MultiplyTool)

public:
    /// @p refused is told why a tap did nothing.
    MultiplyTool(ToolContext& context, std::function<void(const QString& why)> refused)
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

    bool isActive() const override { return m_isDown; }
    void paint(Overlay& overlay) const override;
    QString tip() const override;

    /// The internodes that would come of a tap, or of the drag, each as a line from its base to its node, m.
    const std::vector<std::array<Vec3, 2>>& preview() const { return m_preview; }

private:
    std::optional<InternodeId> axisAt(const PointerSample& sample) const;
    void take(std::optional<InternodeId> axis);
    Propagation propagation() const;
    Result<TreeDelta> result() const;
    void foresee();
    void complete();
    void paintAxis(Overlay& overlay, InternodeId axis, bool isTaken) const;

    std::function<void(const QString& why)> m_refused;
    bool m_isDown = false;
    std::optional<InternodeId> m_axis;  ///< The branch under the pointer, or at which the drag began
    std::vector<InternodeId> m_targets; ///< The axes that the drag has crossed since
    std::uint64_t m_revision = 0;       ///< Of the tree that they are in
    std::vector<std::array<Vec3, 2>> m_preview;
};

} // namespace espalier

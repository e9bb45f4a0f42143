// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/MultiplyTool.h"

#include "commands/MultiplyBranch.h"
#include "commands/PropagateBranch.h"
#include "views/tools/ToolColours.h"

#include <algorithm>

namespace espalier {

namespace {

/// The line over the branch under the pointer, px.
constexpr float kLeastBranchLine = 3.0F;
constexpr float kMostBranchLine = 14.0F;

} // namespace

void MultiplyTool::aim(const PointerSample& sample)
{
    const TreeDocument& document = context().document();
    const std::optional<PickedBranch> picked = context().pick(sample.position, sample.device);
    m_axis = picked ? std::optional(document.index().axis(picked->id)) : std::nullopt;
    m_revision = document.revision();
    context().requestRepaint();
}

void MultiplyTool::begin(const PointerSample& sample)
{
    m_isDown = true;
    aim(sample);
}

void MultiplyTool::move(const PointerSample& sample)
{
    if (m_isDown)
        aim(sample);
}

void MultiplyTool::end(const PointerSample& sample)
{
    move(sample);
    const std::optional<InternodeId> axis = m_isDown ? m_axis : std::nullopt;
    cancel();
    if (!axis)
        return;
    TreeDocument& document = context().document();
    const ViewValues& view = context().viewSettings().values();
    const Result<void> done =
        view.passesOn
            ? propagateBranch(document, {.reference = *axis,
                                         .targets = view.passesOnInOrder ? Propagation::Targets::SameOrder
                                                                         : Propagation::Targets::All,
                                         .axes = {},
                                         .scaling = view.passesOnScaled,
                                         .replaces = view.passesOnAnew})
            : multiplyBranch(document, *axis, document.tree().size());
    if (!done)
        m_refused(done.error().message);
}

void MultiplyTool::cancel()
{
    m_isDown = false;
    leave();
}

void MultiplyTool::leave()
{
    m_axis.reset();
    context().requestRepaint();
}

void MultiplyTool::paint(Overlay& overlay) const
{
    const TreeDocument& document = context().document();
    if (!m_axis || m_revision != document.revision())
        return;
    const Camera& camera = context().camera();
    std::vector<Vec3> line{document.index().basePosition(document.tree(), *m_axis)};
    for (InternodeId id = *m_axis; id != kNoInternode; id = document.index().mainChild(id))
        line.push_back(document.index().nodePosition(id));
    const float depth = std::max(camera.depth(line[1]), Camera::kMinDistance);
    const float width = 2.0F * context().branchRadius(*m_axis) * camera.pixelsPerMetre(depth);
    overlay.addLine(line, kPickedColour, std::clamp(width, kLeastBranchLine, kMostBranchLine));
}

QString MultiplyTool::tip() const
{
    return context().viewSettings().values().passesOn
               ? tr("Tap a branch: other branches get what it carries")
               : tr("Tap a branch: it gets one more branch like those that it carries");
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/MultiplyTool.h"

#include "commands/MultiplyBranch.h"
#include "commands/PropagateBranch.h"
#include "model/sketch/BranchMultiplication.h"
#include "views/tools/ToolColours.h"

#include <algorithm>
#include <utility>

namespace espalier {

namespace {

/// The line over the branch under the pointer, px.
constexpr float kLeastBranchLine = 3.0F;
constexpr float kMostBranchLine = 14.0F;
constexpr float kTargetLine = 2.0F;
constexpr float kPreviewLine = 1.4F;
/// So many of the new internodes show beforehand, those that come first.
constexpr std::uint32_t kMostForeseen = 3'000;

/// The lines of the internodes that a delta adds to a tree.
std::vector<std::array<Vec3, 2>> newLines(const TreeIndex& index, const Tree& tree, const TreeDelta& delta)
{
    std::vector<std::array<Vec3, 2>> lines;
    std::vector<Placement> places;
    const std::uint32_t count = std::min(delta.born.count, kMostForeseen);
    for (std::uint32_t row = 0; row < count; ++row) {
        const InternodeColumns& born = delta.rows->internodes;
        const InternodeId parent = born.parent[row];
        const bool isNew = parent >= delta.born.first;
        const Placement below = isNew ? places[parent - delta.born.first]
                                      : Placement{index.nodePosition(parent), index.rotation(parent)};
        const float length = isNew ? born.length[parent - delta.born.first] : tree.length(parent);
        const Vec3 base =
            below.node - (1.0F - born.along[row]) * length * (below.rotation * Vec3(Vec3::UnitY()));
        places.push_back(placeOn(base, below.rotation, born.rotation[row], born.length[row]));
        lines.push_back({base, places.back().node});
    }
    return lines;
}

} // namespace

std::optional<InternodeId> MultiplyTool::axisAt(const PointerSample& sample) const
{
    const std::optional<PickedBranch> picked = context().pick(sample.position, sample.device);
    return picked ? std::optional(context().document().index().axis(picked->id)) : std::nullopt;
}

/// @p axis is under the pointer, or the drag begins there.
void MultiplyTool::take(std::optional<InternodeId> axis)
{
    const std::uint64_t revision = context().document().revision();
    if (axis == m_axis && m_revision == revision && m_targets.empty())
        return;
    m_axis = axis;
    m_targets.clear();
    m_revision = revision;
    foresee();
}

void MultiplyTool::hover(const PointerSample& sample)
{
    take(axisAt(sample));
}

void MultiplyTool::begin(const PointerSample& sample)
{
    m_isDown = true;
    take(axisAt(sample));
}

void MultiplyTool::move(const PointerSample& sample)
{
    if (!m_isDown)
        return;
    const std::optional<InternodeId> axis = axisAt(sample);
    if (!m_axis || !context().viewSettings().values().passesOn) {
        take(axis);
        return;
    }
    // A way across the tree leads over the trunk.
    if (!axis || context().document().tree().isRoot(*axis) || *axis == *m_axis ||
        std::ranges::find(m_targets, *axis) != m_targets.end())
        return;
    m_targets.push_back(*axis);
    foresee();
}

void MultiplyTool::end(const PointerSample& sample)
{
    move(sample);
    complete();
}

void MultiplyTool::finish()
{
    // A tap that its release has not made yet is none; a drag is kept.
    if (m_targets.empty())
        cancel();
    else
        complete();
}

/// Does what the tap or the drag says.
void MultiplyTool::complete()
{
    const bool isMade =
        std::exchange(m_isDown, false) && m_axis && m_revision == context().document().revision();
    if (isMade) {
        TreeDocument& document = context().document();
        const Result<void> done = context().viewSettings().values().passesOn
                                      ? propagateBranch(document, propagation())
                                      : multiplyBranch(document, *m_axis, document.tree().size());
        if (!done)
            m_refused(done.error().message);
    }
    leave();
}

void MultiplyTool::cancel()
{
    m_isDown = false;
    leave();
}

void MultiplyTool::leave()
{
    m_axis.reset();
    m_targets.clear();
    m_preview.clear();
    context().requestRepaint();
}

Propagation MultiplyTool::propagation() const
{
    const ViewValues& view = context().viewSettings().values();
    Propagation::Targets targets =
        view.passesOnInOrder ? Propagation::Targets::SameOrder : Propagation::Targets::All;
    if (!m_targets.empty())
        targets = Propagation::Targets::Listed;
    return {.reference = *m_axis,
            .targets = targets,
            .axes = m_targets,
            .scaling = view.passesOnScaled,
            .replaces = view.passesOnAnew};
}

/// What lifting the pointer would do.
Result<TreeDelta> MultiplyTool::result() const
{
    const TreeDocument& document = context().document();
    return context().viewSettings().values().passesOn
               ? propagated(document.tree(), document.index(), propagation())
               : multiplied(document.tree(), document.index(), *m_axis, document.tree().size());
}

void MultiplyTool::foresee()
{
    m_preview.clear();
    context().requestRepaint();
    if (!m_axis)
        return;
    const TreeDocument& document = context().document();
    if (const Result<TreeDelta> delta = result())
        m_preview = newLines(document.index(), document.tree(), *delta);
}

void MultiplyTool::paintAxis(Overlay& overlay, InternodeId axis, bool isTaken) const
{
    const TreeDocument& document = context().document();
    const Camera& camera = context().camera();
    std::vector<Vec3> line{document.index().basePosition(document.tree(), axis)};
    for (InternodeId id = axis; id != kNoInternode; id = document.index().mainChild(id))
        line.push_back(document.index().nodePosition(id));
    const float depth = std::max(camera.depth(line[1]), Camera::kMinDistance);
    const float width = 2.0F * context().branchRadius(axis) * camera.pixelsPerMetre(depth);
    overlay.addLine(line, kPickedColour,
                    isTaken ? std::clamp(width, kLeastBranchLine, kMostBranchLine) : kTargetLine);
}

void MultiplyTool::paint(Overlay& overlay) const
{
    if (!m_axis || m_revision != context().document().revision())
        return;
    paintAxis(overlay, *m_axis, true);
    for (const InternodeId target : m_targets)
        paintAxis(overlay, target, false);
    for (const std::array<Vec3, 2>& line : m_preview)
        overlay.addLine(line, kPickedColour, kPreviewLine);
}

QString MultiplyTool::tip() const
{
    return context().viewSettings().values().passesOn
               ? tr("Tap a branch: the others get what it carries; drag from it across branches to choose "
                    "which of them get it")
               : tr("Tap a branch: it gets one more branch like those that it carries");
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/PruneTool.h"

#include "commands/Prune.h"
#include "model/shape/Pruning.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {

namespace {

/// A pointer that moves further than this while it is down makes a stroke, px.
constexpr double kPruneReach = 8.0;
/// Samples nearer than this to the last one add nothing to a stroke, px.
constexpr double kLeastStride = 2.0;
/// Radius of the ring around the place of the cut, px.
constexpr float kPruneRing = 9.0F;

const QColor kFallingColour(235, 84, 72, 200);
const QColor kCutColour(255, 214, 120);

double cross(const QPointF& a, const QPointF& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether two segments of the screen cross.
bool intersect(const QPointF& a, const QPointF& b, const QPointF& c, const QPointF& d)
{
    const double ca = cross(d - c, a - c);
    const double cb = cross(d - c, b - c);
    const double ac = cross(b - a, c - a);
    const double ad = cross(b - a, d - a);
    return ((ca > 0.0) != (cb > 0.0)) && ((ac > 0.0) != (ad > 0.0));
}

} // namespace

void PruneTool::begin(const PointerSample& sample)
{
    m_isActive = true;
    m_isStroke = false;
    m_path = {sample.position};
    aim(sample);
}

void PruneTool::move(const PointerSample& sample)
{
    if (!m_isActive)
        return;
    const QPointF way = sample.position - m_path.front();
    if (!m_isStroke && std::hypot(way.x(), way.y()) > kPruneReach) {
        m_isStroke = true;
        show({});
    }
    if (!m_isStroke)
        return;
    const QPointF stride = sample.position - m_path.back();
    if (std::hypot(stride.x(), stride.y()) < kLeastStride)
        return;
    cutAcross(m_path.back(), sample.position);
    m_path.push_back(sample.position);
    context().requestRepaint();
}

void PruneTool::end(const PointerSample& sample)
{
    if (!m_isActive)
        return;
    move(sample);
    cut();
}

void PruneTool::finish()
{
    if (m_isStroke)
        cut();
    else
        cancel();
}

void PruneTool::cut()
{
    const std::vector<InternodeId> cuts = std::exchange(m_cuts, {});
    cancel();
    pruneBranches(context().document(), cuts);
}

void PruneTool::cancel()
{
    m_isActive = false;
    m_isStroke = false;
    m_path.clear();
    show({});
}

void PruneTool::hover(const PointerSample& sample)
{
    aim(sample);
}

void PruneTool::leave()
{
    show({});
}

/// Shows what a tap would cut off.
void PruneTool::aim(const PointerSample& sample)
{
    const TreeDocument& document = context().document();
    const std::optional<PickedBranch> picked = context().pick(sample.position, sample.device);
    const InternodeId cut = picked ? cutBelow(document.tree(), document.index(), picked->id) : kNoInternode;
    show(cut != kNoInternode ? std::vector<InternodeId>{cut} : std::vector<InternodeId>{});
}

void PruneTool::cutAcross(const QPointF& from, const QPointF& to)
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    const Camera& camera = context().camera();
    std::vector<InternodeId> cuts = m_cuts;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || tree.isRoot(id))
            continue;
        const auto lower = camera.project(index.basePosition(tree, id));
        const auto upper = camera.project(index.nodePosition(id));
        if (lower && upper && intersect(from, to, *lower, *upper))
            cuts.push_back(id);
    }
    if (cuts.size() > m_cuts.size())
        show(std::move(cuts));
}

void PruneTool::show(std::vector<InternodeId> cuts)
{
    const TreeDocument& document = context().document();
    m_cuts = std::move(cuts);
    m_falling = falling(document.tree(), document.index(), m_cuts);
    context().requestRepaint();
}

void PruneTool::paint(Overlay& overlay) const
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    const Camera& camera = context().camera();
    // An undo takes away what the pointer hovers over.
    const auto isGone = [&tree](InternodeId id) { return id >= tree.size() || !tree.isAlive(id); };
    if (std::ranges::any_of(m_falling, isGone) || std::ranges::any_of(m_cuts, isGone))
        return;
    // Axis by axis: a line each.
    std::vector<Vec3> line;
    for (const InternodeId id : m_falling) {
        const InternodeId parent = tree.parent(id);
        if (index.mainChild(parent) == id && std::ranges::binary_search(m_falling, parent))
            continue; // it is drawn with its axis
        line.assign({index.nodePosition(parent)});
        for (InternodeId along = id; along != kNoInternode; along = index.mainChild(along))
            line.push_back(index.nodePosition(along));
        const float width = 2.0F * context().branchRadius(id) * camera.pixelsPerMetre(camera.depth(line[1]));
        overlay.addLine(line, kFallingColour, std::clamp(width, 1.5F, 12.0F));
    }
    for (const InternodeId cut : m_cuts) {
        const Vec3& place = index.nodePosition(tree.parent(cut));
        if (!m_isStroke)
            overlay.addCircle(place, camera.right(), camera.up(),
                              kPruneRing / camera.pixelsPerMetre(camera.depth(place)), kCutColour, 2.0F);
    }
    if (m_isStroke) {
        std::vector<Vec3> blade;
        for (const QPointF& point : m_path)
            blade.push_back(camera.onPlane(point, camera.target()));
        overlay.addLine(blade, kCutColour, 2.0F, 6.0F);
    }
}

QString PruneTool::tip() const
{
    return tr("Tap a branch to take it off, or draw across the branches that shall fall");
}

} // namespace espalier

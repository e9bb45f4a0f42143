// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/CutTool.h"

#include "commands/Prune.h"
#include "model/shape/Pruning.h"
#include "model/shape/SeenWood.h"

#include <cmath>
#include <optional>

namespace espalier {

namespace {

/// A pointer that moves further than this while it is down makes a stroke, px.
constexpr double kPruneReach = 8.0;
/// Samples nearer than this to the last one add nothing to a stroke, px.
constexpr double kLeastStride = 2.0;
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

void CutTool::begin(const PointerSample& sample)
{
    m_isActive = true;
    m_isStroke = false;
    m_path = {sample.position};
    aim(sample);
}

void CutTool::move(const PointerSample& sample)
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

void CutTool::end(const PointerSample& sample)
{
    if (!m_isActive)
        return;
    move(sample);
    cut();
}

void CutTool::finish()
{
    if (m_isStroke)
        cut();
    else
        cancel();
}

void CutTool::cut()
{
    const std::vector<InternodeId> cuts = m_preview.take(context());
    cancel();
    pruneBranches(context().document(), cuts);
}

void CutTool::cancel()
{
    m_isActive = false;
    m_isStroke = false;
    m_path.clear();
    show({});
}

void CutTool::hover(const PointerSample& sample)
{
    aim(sample);
}

void CutTool::leave()
{
    show({});
}

/// Shows what a tap would cut off.
void CutTool::aim(const PointerSample& sample)
{
    const TreeDocument& document = context().document();
    const std::optional<PickedBranch> picked = context().pick(sample.position, sample.device);
    const InternodeId cut = picked ? cutBelow(document.tree(), document.index(), picked->id) : kNoInternode;
    show(cut != kNoInternode ? std::vector<InternodeId>{cut} : std::vector<InternodeId>{});
}

void CutTool::cutAcross(const QPointF& from, const QPointF& to)
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    const Camera& camera = context().camera();
    std::vector<InternodeId> cuts = m_preview.cuts();
    std::optional<NearSide> near;
    if (!context().viewSettings().values().prunesThrough)
        near.emplace(tree, index, camera.position());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || tree.isRoot(id))
            continue;
        const auto lower = camera.project(index.basePosition(tree, id));
        const auto upper = camera.project(index.nodePosition(id));
        if (lower && upper && intersect(from, to, *lower, *upper) &&
            (!near || near->has(id, index.nodePosition(id))))
            cuts.push_back(id);
    }
    if (cuts.size() > m_preview.cuts().size())
        show(std::move(cuts));
}

void CutTool::show(std::vector<InternodeId> cuts)
{
    m_preview.show(context(), std::move(cuts));
}

void CutTool::paint(Overlay& overlay) const
{
    m_preview.paint(context(), overlay, !m_isStroke);
    if (m_isStroke)
        CutPreview::paintBlade(context().camera(), m_path, overlay);
}

QString CutTool::tip() const
{
    return tr("Tap a branch to cut it off, or draw across the branches to cut");
}

} // namespace espalier

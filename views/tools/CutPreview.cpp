// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/CutPreview.h"

#include "model/shape/Pruning.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace espalier {

namespace {

/// Radius of the ring around the place of the cut, px.
constexpr float kPruneRing = 9.0F;
/// Width of the line on falling wood, px: as wide as the wood, in steps of a quarter of an octave.
constexpr float kLeastWidth = 1.5F;
constexpr float kWidthSteps = 4.0F;

const QColor kFallingColour(235, 84, 72, 200);
const QColor kCutColour(255, 214, 120);

} // namespace

void CutPreview::show(ToolContext& context, std::vector<InternodeId> cuts)
{
    const TreeDocument& document = context.document();
    m_cuts = std::move(cuts);
    m_falling = falling(document.tree(), document.index(), m_cuts);
    context.requestRepaint();
}

std::vector<InternodeId> CutPreview::take(ToolContext& context)
{
    std::vector<InternodeId> cuts = std::exchange(m_cuts, {});
    show(context, {});
    return cuts;
}

void CutPreview::paint(ToolContext& context, Overlay& overlay, bool withRings) const
{
    const Tree& tree = context.document().tree();
    const TreeIndex& index = context.document().index();
    const Camera& camera = context.camera();
    // An undo takes away what the pointer hovers over.
    const auto isGone = [&tree](InternodeId id) { return id >= tree.size() || !tree.isAlive(id); };
    if (std::ranges::any_of(m_falling, isGone) || std::ranges::any_of(m_cuts, isGone))
        return;
    // As wide as the wood: internodes of about the same width together.
    std::map<int, std::vector<Vec3>> segments;
    for (const InternodeId id : m_falling) {
        const Vec3 base = index.basePosition(tree, id);
        const Vec3& node = index.nodePosition(id);
        const float depth = camera.depth(node);
        if (depth < Camera::kMinDistance)
            continue;
        const float width = 2.0F * context.branchRadius(id) * camera.pixelsPerMetre(depth);
        const auto step =
            static_cast<int>(std::lround(kWidthSteps * std::log2(std::max(width, kLeastWidth))));
        std::vector<Vec3>& points = segments[step];
        points.push_back(base);
        points.push_back(node);
    }
    for (const auto& [step, points] : segments)
        overlay.addSegments(points, kFallingColour, std::exp2(static_cast<float>(step) / kWidthSteps));
    for (const InternodeId cut : m_cuts) {
        const Vec3 place = index.basePosition(tree, cut);
        if (withRings)
            overlay.addCircle(place, camera.right(), camera.up(),
                              kPruneRing / camera.pixelsPerMetre(camera.depth(place)), kCutColour, 2.0F);
    }
}

void CutPreview::paintBlade(const Camera& camera, std::span<const QPointF> path, Overlay& overlay)
{
    std::vector<Vec3> blade;
    for (const QPointF& point : path)
        blade.push_back(camera.onPlane(point, camera.target()));
    overlay.addLine(blade, kCutColour, 2.0F, 6.0F);
}

} // namespace espalier

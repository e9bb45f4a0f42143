// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/WoodLines.h"

#include "model/base/Parallel.h"
#include "model/strands/StrandCurves.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr std::size_t kLinesPerTask = 256;
/// Strands of a bundle that are looked at to find its middle.
constexpr std::uint32_t kMiddleStrands = 48;
/// A branch that leaves wood at a small angle stays in it for long: at most this share of its first
/// internode counts as inside.
constexpr float kMostInside = 0.9F;

/// The middle of a node's strands at @p t of the way from the node below (0) to the node (1), m.
Vec3 middleOf(const StrandLayouts& layouts, std::uint32_t node, float t)
{
    const StrandCurves curves(layouts);
    const std::uint32_t count = layouts.strandCount(node);
    const std::uint32_t stride = std::max(1U, count / kMiddleStrands);
    Vec3 sum = Vec3::Zero();
    std::uint32_t taken = 0;
    for (std::uint32_t strand = 0; strand < count; strand += stride, ++taken)
        sum += StrandCurves::point(curves.controls(node, strand), t);
    return sum / static_cast<float>(taken);
}

/// The point of a line from @p lower, which lies @p depth deep in other wood with the axis @p support, where
/// it comes out of that.
Vec3 wayOut(const Vec3& lower, const Vec3& upper, const Vec3& axis, const Vec3& support, float depth)
{
    const float sine = axis.cross(support).norm();
    const float length = (upper - lower).norm();
    const float inside = std::max(0.0F, depth) / std::max(sine, 1e-3F);
    return lower + std::min(inside, kMostInside * length) * axis;
}

} // namespace

StrandLines strandLines(const StrandLayouts& layouts, std::uint32_t internodes)
{
    const StrandSkeleton& skeleton = layouts.skeleton();
    StrandLines lines(internodes);
    parallelFor(skeleton.nodes.size(), kLinesPerTask, [&](std::size_t begin, std::size_t end) {
        for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
            const StrandNode& n = skeleton.nodes[node];
            if (n.along != 1.0F || skeleton.isBase(node))
                continue;
            std::uint32_t lowest = node;
            while (skeleton.nodes[skeleton.nodes[lowest].parent].internode == n.internode &&
                   !skeleton.isBase(skeleton.nodes[lowest].parent))
                lowest = skeleton.nodes[lowest].parent;
            WoodLine& line = lines[n.internode];
            line.upper = middleOf(layouts, node, 1.0F);
            line.lower = middleOf(layouts, lowest, 0.0F);
            line.radius = n.radius;
            const Vec3 rise = line.upper - line.lower;
            const float length = rise.norm();
            line.axis = length > 1e-6F ? Vec3(rise / length) : Vec3(n.frame * up());
            const std::uint32_t below = skeleton.nodes[lowest].parent;
            const StrandNode& support = skeleton.nodes[below];
            if (!skeleton.isBase(below) && 2 * n.strands < support.strands) {
                const Vec3 along = support.frame * up();
                const Vec3 off = line.lower - layouts.centre(below);
                const float depth = support.radius - (off - off.dot(along) * along).norm();
                line.lower = wayOut(line.lower, line.upper, line.axis, along, depth);
            }
        }
    });
    return lines;
}

WoodLine WoodLines::of(InternodeId id) const
{
    if (isStrand(id))
        return m_strands[id];
    WoodLine line;
    line.upper = m_index.nodePosition(id);
    line.axis = m_index.heading(id);
    line.lower = line.upper - m_tree.length(id) * line.axis;
    line.radius = m_widths.radius(m_index, id);
    const InternodeId parent = m_tree.parent(id);
    if (parent != kNoInternode && m_index.axis(id) == id)
        line.lower = wayOut(line.lower, line.upper, line.axis, m_index.heading(parent),
                            m_widths.radius(m_index, parent));
    return line;
}

} // namespace espalier

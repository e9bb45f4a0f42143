// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandCurves.h"

#include <algorithm>

namespace espalier {

namespace {

/// The mean is taken over so many places to either side.
constexpr int kMeanSamples = 3;
/// The mean of a strand below a fork includes the branch that it passes into unless the fork has more than so
/// many times its strands. Those of thin branches would draw spikes out of the bark.
constexpr std::uint32_t kMostTimesTheBranch = 8;

} // namespace

Vec3 StrandCurves::Line::at(float path) const
{
    std::size_t i = 1;
    while (i + 1 < count && paths[i] < path)
        ++i;
    const float length = paths[i] - paths[i - 1];
    const float t = length > 0.0F ? std::clamp((path - paths[i - 1]) / length, 0.0F, 1.0F) : 0.0F;
    return points[i - 1] + t * (points[i] - points[i - 1]);
}

StrandCurves::Line StrandCurves::lineAbove(std::uint32_t node, std::uint32_t strand, const Vec3& begin,
                                           float reach) const
{
    Line line;
    line.add(begin, 0.0F);
    while (line.count < kMostNodes && line.length() < reach && m_skeleton.nodes[node].childCount > 0) {
        const std::uint32_t child = childWith(node, strand);
        const StrandNode& c = m_skeleton.nodes[child];
        if (kMostTimesTheBranch * c.strands < m_skeleton.nodes[node].strands)
            break;
        strand -= c.offset;
        node = child;
        line.add(raw(node, strand), line.length() + lengthTo(node));
    }
    return line;
}

StrandCurves::Line StrandCurves::lineBelow(std::uint32_t node, std::uint32_t strand, const Vec3& begin,
                                           float reach) const
{
    Line line;
    line.add(begin, 0.0F);
    while (line.count < kMostNodes && line.length() < reach && !m_skeleton.isBase(node)) {
        const StrandNode& n = m_skeleton.nodes[node];
        const float length = lengthTo(node);
        strand += n.offset;
        node = n.parent;
        line.add(raw(node, strand), line.length() + length);
    }
    return line;
}

Vec3 StrandCurves::place(std::uint32_t node, std::uint32_t strand) const
{
    Vec3 sum = raw(node, strand);
    float reach = m_layouts.reach(node);
    if (reach <= 0.0F)
        return sum;
    const Line above = lineAbove(node, strand, sum, reach);
    reach = std::min(reach, above.length());
    if (reach <= 0.0F)
        return sum;
    const Line below = lineBelow(node, strand, sum, reach);
    reach = std::min(reach, below.length());
    if (reach <= 0.0F)
        return sum;
    float weights = 1.0F;
    for (int k = 1; k < kMeanSamples; ++k) {
        const float share = static_cast<float>(k) / kMeanSamples;
        sum += (1.0F - share) * (above.at(share * reach) + below.at(share * reach));
        weights += 2.0F * (1.0F - share);
    }
    return sum / weights;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/ProfileShapes.h"
#include "model/strands/StrandLayouts.h"
#include "tests/support/TreeBuilder.h"

#include <limits>

namespace espalier::test {

inline StrandLayouts layoutsOf(const Tree& tree, const TreeIndex& index)
{
    return {tree, index, Widths(tree, index)};
}
inline StrandLayouts layoutsOf(const TreeBuilder& builder)
{
    return layoutsOf(builder.tree, builder.index);
}

/// Parameters that pack @p strandsPerTip strands a tip.
inline TreeParameters strandParameters(int strandsPerTip, StrandPacking packing = StrandPacking::Rest,
                                       int steps = 500)
{
    TreeParameters parameters;
    parameters.wood.strandsPerTip = strandsPerTip;
    parameters.wood.packing = packing;
    parameters.wood.steps = steps;
    return parameters;
}

/// An edit that gives a node a profile.
inline TreeDelta profileChange(const Tree& tree, InternodeId id, const StrandProfile& profile)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.sparse.profile.push_back(
        {id, tree.content().sparse.profile.at(id), keepProfile(delta, tree, profile)});
    return delta;
}

/// An edit that turns the strands at a node, rad.
inline TreeDelta twistChange(const Tree& tree, InternodeId id, float twist)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.sparse.twist.push_back({id, tree.content().sparse.twist.at(id), twist});
    return delta;
}

inline StrandProfile polygon(std::initializer_list<Vec2> points)
{
    return {{StrandProfile::Loop(points)}, {}};
}
inline StrandProfile rectangle(float width, float height, const Vec2& centre = Vec2::Zero())
{
    const Vec2 x(width / 2.0F, 0.0F);
    const Vec2 y(0.0F, height / 2.0F);
    return polygon({centre - x - y, centre + x - y, centre + x + y, centre - x + y});
}
/// A band of @p width along three sides of a square with edge 2.
inline StrandProfile thinC(float width)
{
    return polygon({{-1.0F, -1.0F},
                    {1.0F, -1.0F},
                    {1.0F, -1.0F + width},
                    {-1.0F + width, -1.0F + width},
                    {-1.0F + width, 1.0F - width},
                    {1.0F, 1.0F - width},
                    {1.0F, 1.0F},
                    {-1.0F, 1.0F}});
}
inline StrandProfile scaled(StrandProfile profile, float factor)
{
    for (StrandProfile::Loop& loop : profile.boundaries) {
        for (Vec2& point : loop)
            point *= factor;
    }
    for (auto& [from, to] : profile.attractors) {
        from *= factor;
        to *= factor;
    }
    return profile;
}

/// The distance of the nearest two of @p places; infinite for fewer. Quadratic.
inline float nearestPair(std::span<const Vec2> places)
{
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = i + 1; j < places.size(); ++j)
            nearest = std::min(nearest, (places[i] - places[j]).squaredNorm());
    }
    return std::sqrt(nearest);
}

/// How far a point is outside a profile, in the profile's coordinates; 0 inside.
inline float distanceOutside(const StrandProfile& profile, const Vec2& point)
{
    if (isInside(profile, point))
        return 0.0F;
    float nearest = std::numeric_limits<float>::max();
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
            const Vec2 edge = loop[i] - loop[j];
            const float t = std::clamp((point - loop[j]).dot(edge) / edge.squaredNorm(), 0.0F, 1.0F);
            nearest = std::min(nearest, (point - loop[j] - t * edge).norm());
        }
    }
    return nearest;
}

/// The node of the skeleton at the upper end of an internode.
inline std::uint32_t nodeOf(const StrandLayouts& layouts, InternodeId id)
{
    const std::vector<StrandNode>& nodes = layouts.skeleton().nodes;
    const auto found = std::ranges::find_if(
        nodes, [id](const StrandNode& n) { return n.internode == id && n.along == 1.0F; });
    return static_cast<std::uint32_t>(found - nodes.begin());
}

inline std::vector<Vec2> placesAt(const StrandLayouts& layouts, std::uint32_t node)
{
    std::vector<Vec2> places;
    for (std::uint32_t i = 0; i < layouts.strandCount(node); ++i)
        places.push_back(layouts.place(node, i));
    return places;
}

/// A tree of @p tips tips whose forks divide them as 28 to 72; branches of many tips have longer stretches
/// without forks. 14,600 tips have about 42,000 nodes, and strands pass about 650,000 of them.
inline TreeBuilder forkedTree(std::uint32_t tips, const TreeParameters& parameters = {})
{
    std::vector<NewInternode> internodes;
    struct Branch {
        InternodeId parent;
        int slot;
        std::uint32_t tips;
    };
    std::vector<Branch> open{{0, kTerminalSlot, tips}};
    for (std::size_t i = 0; i < open.size(); ++i) {
        const Branch branch = open[i];
        InternodeId parent = branch.parent;
        const int length = branch.tips > 150 ? 4 : branch.tips > 1 ? 1 : i % 8 < 7 ? 2 : 1;
        for (int j = 0; j < length; ++j) {
            const bool isLateral = j == 0 && branch.slot != kTerminalSlot;
            internodes.push_back({.parent = parent,
                                  .slot = isLateral ? branch.slot : kTerminalSlot,
                                  .rotation = isLateral ? branching(0.8) : continuing(0.08)});
            parent = static_cast<InternodeId>(internodes.size());
        }
        if (branch.tips > 1) {
            const std::uint32_t side = std::max(1U, branch.tips * 28 / 100);
            open.push_back({parent, kTerminalSlot, branch.tips - side});
            open.push_back({parent, 0, side});
        }
    }
    TreeBuilder builder(1, parameters);
    builder.apply(births(builder.tree, internodes));
    return builder;
}

} // namespace espalier::test

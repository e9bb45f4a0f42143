// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandReuse.h"

#include "model/base/ContentHash.h"
#include "model/base/Parallel.h"
#include "model/strands/StrandCurves.h"

namespace espalier {

namespace {

constexpr std::size_t kHashesPerTask = 256;
/// Steps to the reach of positions; each further reach is one step more.
constexpr int kNearestReach = 3;

void addVector(ContentHash& hash, const Vec3& vector)
{
    hash.add(vector.x());
    hash.add(vector.y());
    hash.add(vector.z());
}

/// The inputs that belong to a node itself. @p content: a hash of the places of its strands.
std::uint64_t ownKey(const StrandLayouts& layouts, std::uint32_t node, std::uint64_t content)
{
    const StrandNode& n = layouts.skeleton().nodes[node];
    ContentHash hash;
    hash.add(content);
    hash.add(n.internode);
    hash.add(n.along);
    hash.add(n.childCount);
    hash.add(n.strands);
    hash.add(n.offset);
    hash.add(n.radius);
    addVector(hash, n.position);
    for (const float number : n.frame.coeffs())
        hash.add(number);
    hash.add(layouts.isDisc(node));
    hash.add(layouts.scale(node));
    hash.add(layouts.reach(node));
    addVector(hash, layouts.centre(node));
    layouts.reliefs().addTo(hash, node);
    return hash.value();
}

/// Adds the nodes above @p node that the lines of its strands can pass within @p reach, m.
void addLinesAbove(ContentHash& hash, const StrandLayouts& layouts, const std::vector<std::uint64_t>& keys,
                   std::uint32_t node, float reach, std::size_t nodesLeft)
{
    const StrandSkeleton& skeleton = layouts.skeleton();
    for (const std::uint32_t child : skeleton.childrenOf(node)) {
        hash.add(keys[child]);
        const float length = (layouts.centre(child) - layouts.centre(node)).norm();
        if (length < reach && nodesLeft > 0)
            addLinesAbove(hash, layouts, keys, child, reach - length, nodesLeft - 1);
    }
}

/// The keys of what StrandCurves::place depends on: those of a node, and where its strands are rounded, of
/// all nodes that their lines can pass.
std::uint64_t placeKey(const StrandLayouts& layouts, const std::vector<std::uint64_t>& keys,
                       std::uint32_t node)
{
    const StrandSkeleton& skeleton = layouts.skeleton();
    // Rounding of sums must not leave out a node that a line passes.
    const float reach = 1.01F * layouts.reach(node);
    if (reach <= 0.0F)
        return keys[node];
    ContentHash hash;
    hash.add(keys[node]);
    addLinesAbove(hash, layouts, keys, node, reach, StrandCurves::kMostNodes);
    float left = reach;
    for (std::size_t i = 0; i < StrandCurves::kMostNodes && left > 0.0F && !skeleton.isBase(node); ++i) {
        const std::uint32_t below = skeleton.nodes[node].parent;
        left -= (layouts.centre(node) - layouts.centre(below)).norm();
        node = below;
        hash.add(keys[node]);
    }
    return hash.value();
}

/// Each node's key together with those of its neighbours: they reach one step further.
std::vector<std::uint64_t> spread(const StrandSkeleton& skeleton, const std::vector<std::uint64_t>& keys)
{
    std::vector<std::uint64_t> result(keys.size());
    parallelFor(keys.size(), kHashesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto node = static_cast<std::uint32_t>(i);
            ContentHash hash;
            hash.add(keys[i]);
            hash.add(skeleton.isBase(node) ? 0 : keys[skeleton.nodes[i].parent]);
            for (const std::uint32_t child : skeleton.childrenOf(node))
                hash.add(keys[child]);
            result[i] = hash.value();
        }
    });
    return result;
}

} // namespace

StrandKeys strandKeys(const StrandLayouts& layouts, const WoodParameters& wood,
                      const WoodMeshOptions& options)
{
    const StrandSkeleton& skeleton = layouts.skeleton();
    const std::size_t count = skeleton.nodes.size();
    ContentHash common;
    common.add(wood.alpha);
    common.add(wood.smoothing);
    common.add(options.tolerance);
    std::vector<std::uint64_t> contents(count);
    parallelFor(count, kHashesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto node = static_cast<std::uint32_t>(i);
            if (layouts.owner(node) != node)
                continue;
            ContentHash hash;
            hash.add(common.value());
            const std::span<const Vec2> places = layouts.places(node);
            hash.addAll(std::span(reinterpret_cast<const float*>(places.data()), 2 * places.size()));
            if (layouts.isDisc(node))
                hash.addAll(layouts.slots(node));
            contents[i] = hash.value();
        }
    });
    std::vector<std::uint64_t> keys(count);
    parallelFor(count, kHashesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto node = static_cast<std::uint32_t>(i);
            keys[i] = ownKey(layouts, node, contents[layouts.owner(node)]);
        }
    });
    std::vector<std::uint64_t> places(count);
    parallelFor(count, kHashesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            places[i] = placeKey(layouts, keys, static_cast<std::uint32_t>(i));
    });
    keys = std::move(places);
    for (int step = 0; step < kNearestReach; ++step)
        keys = spread(skeleton, keys);
    StrandKeys result;
    result.ofNodes[0] = std::move(keys);
    for (std::size_t reach = 1; reach < kStrandReachCount; ++reach)
        result.ofNodes[reach] = spread(skeleton, result.ofNodes[reach - 1]);
    return result;
}

StrandReuse::StrandReuse(const StrandLayouts& layouts, const WoodParameters& wood,
                         const WoodMeshOptions& options, const StrandKeys* last,
                         const StrandSkeleton* lastSkeleton)
    : m_lastSkeleton(lastSkeleton),
      m_keys(strandKeys(layouts, wood, options)),
      m_before(layouts.skeleton().nodes.size(), kNoNode),
      m_reach(layouts.skeleton().nodes.size(), 0)
{
    // The tubes of a mesh whose outlines were thinned are no longer those that were found.
    if (last == nullptr || options.tolerance > WoodMeshOptions{}.tolerance)
        return;
    m_before = matchingNodes(layouts.skeleton(), *lastSkeleton);
    for (std::uint32_t i = 0; i < m_before.size(); ++i) {
        while (m_before[i] != kNoNode && m_reach[i] < kStrandReachCount &&
               m_keys.ofNodes[m_reach[i]][i] == last->ofNodes[m_reach[i]][m_before[i]])
            ++m_reach[i];
    }
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandSkeleton.h"

#include "model/base/Parallel.h"
#include "model/strands/JoinedForks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {

namespace {

constexpr std::size_t kRoundedPerTask = 512;
/// Attachments that are nearer to an end than this share of the internode count as there.
constexpr float kAtBase = 0.001F;
constexpr float kAtNode = 0.999F;
/// Kinks of the wood's line are rounded over this many of its radii to either side, which is seen in so many
/// places.
constexpr float kRoundedRadii = 1.5F;
constexpr int kRoundedSamples = 4;
/// The sections of a branch turn to its direction over this many radii of the wood that it leaves.
constexpr float kTiltRadii = 2.0F;

/// The places below its node at which an internode bears branches, ascending.
std::vector<float> attachments(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    std::vector<float> places;
    for (InternodeId child = index.firstChild(id); child != kNoInternode; child = index.nextSibling(child)) {
        if (const float along = tree.columns().along[child]; along > kAtBase && along < kAtNode)
            places.push_back(along);
    }
    std::ranges::sort(places);
    // Places that nearly coincide would make sections that do.
    const auto last = std::ranges::unique(places, [](float a, float b) { return b - a < kAtBase; }).begin();
    places.erase(last, places.end());
    return places;
}

/// Makes the nodes, without children, strands and frames.
class NodeBuilder {
public:
    NodeBuilder(const Tree& tree, const TreeIndex& index, const Widths& widths, StrandSkeleton& skeleton)
        : m_tree(tree), m_index(index), m_widths(widths), m_skeleton(skeleton), m_last(tree.size(), 0)
    {
    }

    void build()
    {
        m_skeleton.nodes.reserve(m_index.livingCount() + 1);
        for (InternodeId id = 0; id < m_tree.size(); ++id) {
            if (m_tree.isAlive(id))
                addInternode(id);
        }
    }

private:
    std::uint32_t add(InternodeId id, float along, std::uint32_t parent)
    {
        const auto node = static_cast<std::uint32_t>(m_skeleton.nodes.size());
        StrandNode& made = m_skeleton.nodes.emplace_back();
        made.internode = id;
        made.along = along;
        made.parent = parent == kNoInternode ? node : parent;
        made.radius = m_widths.radius(m_index, id);
        const Vec3& end = m_index.nodePosition(id);
        made.position =
            along == 1.0F ? end : Vec3(end - (1.0F - along) * m_tree.length(id) * m_index.heading(id));
        return node;
    }

    /// The node on the parent, or the one below it, that the internode @p id begins at.
    std::uint32_t supportOf(InternodeId id)
    {
        const InternodeId parent = m_tree.parent(id);
        if (parent == kNoInternode) {
            const std::uint32_t base = add(id, 0.0F, kNoInternode);
            m_skeleton.bases.push_back(base);
            return base;
        }
        const float along = m_tree.columns().along[id];
        std::uint32_t node = m_last[parent];
        if (along >= kAtNode)
            return node;
        // The nodes of the parent come one after another.
        while (m_skeleton.nodes[node].internode == parent && m_skeleton.nodes[node].along > along &&
               m_skeleton.nodes[node].parent != node)
            node = m_skeleton.nodes[node].parent;
        return node;
    }

    void addInternode(InternodeId id)
    {
        std::uint32_t below = supportOf(id);
        for (const float along : attachments(m_tree, m_index, id))
            below = add(id, along, below);
        m_last[id] = add(id, 1.0F, below);
    }

    const Tree& m_tree;
    const TreeIndex& m_index;
    const Widths& m_widths;
    StrandSkeleton& m_skeleton;
    std::vector<std::uint32_t> m_last; ///< By internode: its own node
};

void linkChildren(StrandSkeleton& skeleton)
{
    std::vector<StrandNode>& nodes = skeleton.nodes;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent != i)
            ++nodes[nodes[i].parent].childCount;
    }
    std::uint32_t first = 0;
    for (StrandNode& node : nodes) {
        node.firstChild = first;
        first += std::exchange(node.childCount, 0U);
    }
    skeleton.children.resize(first);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent == i)
            continue;
        StrandNode& parent = nodes[nodes[i].parent];
        skeleton.children[parent.firstChild + parent.childCount++] = i;
    }
}

void countStrands(StrandSkeleton& skeleton, std::uint32_t perTip)
{
    std::vector<StrandNode>& nodes = skeleton.nodes;
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (nodes[i].childCount == 0)
            nodes[i].strands = perTip;
        if (nodes[i].parent != i)
            nodes[nodes[i].parent].strands += nodes[i].strands;
    }
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        std::uint32_t offset = 0;
        for (const std::uint32_t child : skeleton.childrenOf(i))
            nodes[child].offset = std::exchange(offset, offset + nodes[child].strands);
    }
}

/// The child that carries the most strands, the first of them if several do; the node itself if it has none.
std::uint32_t thickestChild(const StrandSkeleton& skeleton, std::uint32_t node)
{
    std::uint32_t thickest = node;
    for (const std::uint32_t child : skeleton.childrenOf(node)) {
        if (thickest == node || skeleton.nodes[child].strands > skeleton.nodes[thickest].strands)
            thickest = child;
    }
    return thickest;
}

/// The place on the tree's line at @p distance, m, above a node, or below it if that is negative; at most
/// as far as the line goes.
Vec3 placeAlong(const StrandSkeleton& skeleton, std::uint32_t node, float distance)
{
    float left = std::abs(distance);
    for (;;) {
        const std::uint32_t next =
            distance < 0.0F ? skeleton.nodes[node].parent : thickestChild(skeleton, node);
        const Vec3& from = skeleton.nodes[node].position;
        if (next == node)
            return from;
        const Vec3 step = skeleton.nodes[next].position - from;
        const float length = step.norm();
        if (length > left)
            return from + left / length * step;
        left -= length;
        node = next;
    }
}

/// Height of a node above the base of its root along the branches, m, but not more than @p most.
float pathToBase(const StrandSkeleton& skeleton, std::uint32_t node, float most)
{
    float path = 0.0F;
    while (path < most && !skeleton.isBase(node)) {
        const StrandNode& n = skeleton.nodes[node];
        path += (n.position - skeleton.nodes[n.parent].position).norm();
        node = n.parent;
    }
    return std::min(path, most);
}

/// Rounds kinks that are sharper than the wood is thick, where sections would cut each other: each node moves
/// to the mean of the line around it. Bases and tips stay.
void roundKinks(StrandSkeleton& skeleton)
{
    std::vector<Vec3> rounded(skeleton.nodes.size());
    parallelFor(rounded.size(), kRoundedPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto node = static_cast<std::uint32_t>(i);
            const StrandNode& n = skeleton.nodes[i];
            rounded[i] = n.position;
            if (n.childCount == 0 || skeleton.isBase(node))
                continue;
            const float reach = pathToBase(skeleton, node, kRoundedRadii * n.radius);
            Vec3 sum = n.position;
            float weights = 1.0F;
            for (int k = 1; k < kRoundedSamples; ++k) {
                const float share = static_cast<float>(k) / kRoundedSamples;
                const float weight = 1.0F - share;
                sum += weight * (placeAlong(skeleton, node, share * reach) +
                                 placeAlong(skeleton, node, -share * reach));
                weights += 2.0F * weight;
            }
            rounded[i] = sum / weights;
        }
    });
    for (std::size_t i = 0; i < rounded.size(); ++i)
        skeleton.nodes[i].position = rounded[i];
}

/// Direction of the line at a node: from below it to above it, as far from it as the wood is thick.
Vec3 directionAt(const StrandSkeleton& skeleton, std::uint32_t node, const Vec3& otherwise)
{
    const float reach = skeleton.nodes[node].radius;
    const Vec3 rise = placeAlong(skeleton, node, reach) - placeAlong(skeleton, node, -reach);
    const float length = rise.norm();
    return length > 1e-7F ? Vec3(rise / length) : otherwise;
}

/// How the sections of a branch turn from that of the fork to its own direction.
struct Tilt {
    Vec3 from = Vec3::Zero(); ///< Normal of the fork's section
    float path = 0.0F;        ///< m, from the fork
    float reach = 0.0F;       ///< m, over which the sections turn; 0 for a trunk
};

/// By how much the section of a node is turned against the one below it.
Rotation twistOf(const Tree& tree, const StrandNode& node)
{
    const float* const twist =
        node.along == 1.0F ? tree.content().sparse.twist.find(node.internode) : nullptr;
    if (twist == nullptr)
        return Rotation::Identity();
    // Strands that wind to the left turn clockwise, seen from the tip.
    return Rotation(Eigen::AngleAxisf(-*twist, up()));
}

void transportFrames(const Tree& tree, const TreeIndex& index, StrandSkeleton& skeleton)
{
    std::vector<StrandNode>& nodes = skeleton.nodes;
    std::vector<Tilt> tilts(nodes.size());
    // What is transported are frames along the internodes: how the line is rounded and how a branch's first
    // sections are tilted depends on the radii below, and must not turn all that is above.
    std::vector<Rotation> upright(nodes.size());
    std::vector<Vec3> normals(nodes.size());
    parallelFor(nodes.size(), kRoundedPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            normals[i] =
                directionAt(skeleton, static_cast<std::uint32_t>(i), index.heading(nodes[i].internode));
    });
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        StrandNode& node = nodes[i];
        const bool isBase = node.parent == i;
        const Vec3 heading = index.heading(node.internode);
        Vec3 normal = normals[i];
        // The whole foot of a trunk stands on the ground, also if the trunk leans.
        if (isBase)
            normal = heading.y() > 0.0F ? up() : heading;
        normal.normalize();
        const Rotation below = isBase ? index.rotation(node.internode) : upright[node.parent];
        upright[i] =
            (Rotation::FromTwoVectors(below * up(), heading) * below * twistOf(tree, node)).normalized();
        node.frame = (Rotation::FromTwoVectors(upright[i] * up(), normal) * upright[i]).normalized();
        if (!isBase) {
            const StrandNode& support = nodes[node.parent];
            const float length = (node.position - support.position).norm();
            Tilt& tilt = tilts[i];
            if (2 * node.strands >= support.strands) {
                tilt = tilts[node.parent];
                tilt.path += length;
            } else {
                tilt = {support.frame * up(), length, kTiltRadii * support.radius};
            }
            if (tilt.path < tilt.reach) {
                const float share = tilt.path / tilt.reach;
                const Vec3 between = (1.0F - share) * tilt.from + share * normal;
                if (between.squaredNorm() > 1e-2F)
                    node.frame = (Rotation::FromTwoVectors(normal, between) * node.frame).normalized();
            }
        }
    }
}

} // namespace

std::vector<std::uint32_t> matchingNodes(const StrandSkeleton& skeleton, const StrandSkeleton& other)
{
    const auto placeOf = [](const StrandNode& node) { return std::pair(node.internode, node.along); };
    // Joined forks change the order of the nodes.
    const auto byPlace = [&](const StrandSkeleton& of) {
        std::vector<std::uint32_t> order(of.nodes.size());
        std::iota(order.begin(), order.end(), 0U);
        if (!std::ranges::is_sorted(of.nodes, {}, placeOf))
            std::ranges::sort(order, {}, [&](std::uint32_t i) { return placeOf(of.nodes[i]); });
        return order;
    };
    std::vector<std::uint32_t> result(skeleton.nodes.size(), kNoNode);
    const std::vector<std::uint32_t> others = byPlace(other);
    auto match = others.begin();
    for (const std::uint32_t node : byPlace(skeleton)) {
        const auto place = placeOf(skeleton.nodes[node]);
        while (match != others.end() && placeOf(other.nodes[*match]) < place)
            ++match;
        if (match == others.end())
            break;
        if (placeOf(other.nodes[*match]) == place)
            result[node] = *match;
    }
    return result;
}

StrandSkeleton strandSkeleton(const Tree& tree, const TreeIndex& index, const Widths& widths)
{
    StrandSkeleton skeleton;
    NodeBuilder(tree, index, widths, skeleton).build();
    joinForks(skeleton, tree.parameters().wood);
    linkChildren(skeleton);
    countStrands(skeleton, static_cast<std::uint32_t>(tree.parameters().wood.strandsPerTip));
    roundKinks(skeleton);
    transportFrames(tree, index, skeleton);
    return skeleton;
}

} // namespace espalier

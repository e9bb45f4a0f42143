// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandBark.h"

#include "model/base/Parallel.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

using Slice = StrandSections::Slice;
using Loop = StrandSections::Loop;

/// Branches with less than this share of the vertices are assigned each by one thread.
constexpr std::uint64_t kParts = 64;

/// Assigns u and v. For one thread; several of them can share @p repeats.
class BarkCoordinates {
public:
    BarkCoordinates(const StrandLayouts& layouts, const StrandTubes& tubes, const StrandSections& sections,
                    const TreeParameters& parameters, BranchMesh& mesh, std::vector<float>& repeats)
        : m_layouts(layouts),
          m_skeleton(layouts.skeleton()),
          m_tubes(tubes),
          m_sections(sections),
          m_scale(static_cast<float>(parameters.bark.scale)),
          m_mesh(mesh),
          m_repeats(repeats)
    {
        std::uint32_t most = 0;
        for (const StrandNode& node : m_skeleton.nodes)
            most = std::max(most, node.strands);
        m_known.resize(most);
        m_stamp.assign(most, 0);
    }

    /// Assigns those of @p nodes; those of the nodes below them come first.
    void assign(std::span<const std::uint32_t> nodes)
    {
        for (const std::uint32_t node : nodes) {
            if (m_skeleton.isBase(node))
                assignBase(node);
            else
                assignNode(node);
        }
    }

private:
    float repeatsOf(float radius) const
    {
        return std::max(1.0F, std::round(2.0F * std::numbers::pi_v<float> * radius / m_scale));
    }

    Vec3 at(VertexIndex vertex) const { return toVec3(m_mesh.vertices[vertex].position); }
    float& u(VertexIndex vertex) { return m_mesh.vertices[vertex].uv[0]; }
    float& v(VertexIndex vertex) { return m_mesh.vertices[vertex].uv[1]; }

    void assignBase(std::uint32_t node)
    {
        const StrandNode& n = m_skeleton.nodes[node];
        const auto above = m_skeleton.childrenOf(node);
        // The radius without the flare.
        m_repeats[node] = repeatsOf(above.empty() ? n.radius : m_skeleton.nodes[above.front()].radius);
        forget();
        for (const Slice& slice : m_sections.block(node).whole)
            assignSlice(slice, nullptr, 0.0F, m_repeats[node]);
        if (const StrandSections::Block& block = m_sections.block(node); block.hasApex) {
            u(block.apex) = 0.5F * m_repeats[node];
            v(block.apex) = 0.0F;
        }
    }

    void assignNode(std::uint32_t node)
    {
        const StrandNode& n = m_skeleton.nodes[node];
        const StrandNode& below = m_skeleton.nodes[n.parent];
        const StrandSections::Block& block = m_sections.block(node);
        const Slice& support = m_sections.block(n.parent).top();
        m_repeats[node] = 2 * n.strands >= below.strands ? m_repeats[n.parent] : repeatsOf(n.radius);
        float top = 0.0F;
        const Slice* last = &support;
        for (std::size_t tube = 0; tube < m_tubes.nodes[node].tubes.size(); ++tube) {
            last = &support;
            forget();
            learn(support, n.offset);
            for (const Slice& slice : block.slicesOf(tube)) {
                assignSlice(slice, last, v(last->loops.front().first), m_repeats[node]);
                learn(slice, 0);
                last = &slice;
            }
        }
        top = v(last->loops.front().first);
        if (m_tubes.nodes[node].tubes.size() > 1) {
            for (std::size_t tube = 0; tube < m_tubes.nodes[node].tubes.size(); ++tube)
                learn(block.slicesOf(tube).back(), 0);
        }
        for (const Slice& slice : block.whole) {
            assignSlice(slice, last, top, m_repeats[node]);
            learn(slice, 0);
            last = &slice;
            top = v(slice.loops.front().first);
        }
        if (n.childCount == 0) {
            u(block.apex) = u(last->loops.front().first);
            v(block.apex) = top + heightOf(at(block.apex) - last->centre, last->radius, m_repeats[node]);
        }
    }

    void forget() { ++m_round; }
    void learn(const Slice& slice, std::uint32_t offset)
    {
        for (const Loop& loop : slice.loops) {
            const auto strands = m_sections.strands(loop);
            for (std::uint32_t i = 0; i < strands.size(); ++i) {
                if (strands[i] < offset)
                    continue;
                m_known[strands[i] - offset] = u(loop.first + i);
                m_stamp[strands[i] - offset] = m_round;
            }
        }
    }

    static float heightOf(const Vec3& rise, float radius, float repeats)
    {
        return rise.norm() * repeats / (2.0F * std::numbers::pi_v<float> * std::max(radius, 1e-6F));
    }

    void assignSlice(const Slice& slice, const Slice* below, float vBelow, float repeats)
    {
        const float height = below == nullptr
                                 ? 0.0F
                                 : vBelow + heightOf(slice.centre - below->centre,
                                                     0.5F * (slice.radius + below->radius), repeats);
        for (const Loop& loop : slice.loops) {
            for (std::uint32_t i = 0; i < loop.count; ++i)
                v(loop.first + i) = height;
            assignLoop(loop, slice.centre, below, repeats);
        }
    }

    /// u of the vertex of @p slice that is nearest to @p place.
    float nearestU(const Slice& slice, const Vec3& place)
    {
        float least = std::numeric_limits<float>::max();
        float result = 0.0F;
        for (const Loop& loop : slice.loops) {
            for (std::uint32_t i = 0; i < loop.count; ++i) {
                if (const float distance = (at(loop.first + i) - place).squaredNorm(); distance < least) {
                    least = distance;
                    result = u(loop.first + i);
                }
            }
        }
        return result;
    }

    void assignLoop(const Loop& loop, const Vec3& centre, const Slice* below, float repeats)
    {
        // Length along the loop up to each vertex, in shares of the whole.
        m_arc.assign(loop.count + 1, 0.0F);
        for (std::uint32_t i = 0; i < loop.count; ++i)
            m_arc[i + 1] = m_arc[i] + (at(loop.first + (i + 1) % loop.count) - at(loop.first + i)).norm();
        const float length = std::max(m_arc.back(), 1e-9F);
        for (float& arc : m_arc)
            arc /= length;
        const auto strands = m_sections.strands(loop);
        m_fixed.clear();
        for (std::uint32_t i = 0; i < strands.size(); ++i) {
            if (m_stamp[strands[i]] == m_round)
                m_fixed.push_back(i);
        }
        if (m_fixed.empty()) {
            // Rings follow rings with the same angles; at a fork the nearest place of the outline below
            // counts.
            Vec3 place = at(loop.first);
            if (below != nullptr && !below->loops.front().hasStrands)
                place += below->centre - centre;
            const float phase = below == nullptr ? 0.0F : nearestU(*below, place);
            for (std::uint32_t i = 0; i < loop.count; ++i)
                u(loop.first + i) = phase + repeats * m_arc[i];
            return;
        }
        for (std::size_t f = 0; f < m_fixed.size(); ++f) {
            const std::uint32_t from = m_fixed[f];
            const std::uint32_t to = m_fixed[(f + 1) % m_fixed.size()];
            const float start = m_known[strands[from]];
            u(loop.first + from) = start;
            const std::uint32_t between = (to + loop.count - from - 1) % loop.count + 1;
            if (between == 1)
                continue;
            float share = m_arc[to] - m_arc[from];
            if (share <= 0.0F)
                share += 1.0F;
            float rise = m_known[strands[to]] - start;
            rise += std::round(repeats * share - rise);
            for (std::uint32_t j = 1; j < between; ++j) {
                const std::uint32_t i = (from + j) % loop.count;
                float part = m_arc[i] - m_arc[from];
                if (part < 0.0F)
                    part += 1.0F;
                u(loop.first + i) = start + rise * part / share;
            }
        }
    }

    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
    const StrandTubes& m_tubes;
    const StrandSections& m_sections;
    float m_scale;
    BranchMesh& m_mesh;
    std::vector<float>& m_repeats; ///< By node: of the texture around it
    std::vector<float> m_known;    ///< u by strand, where m_stamp is the present round
    std::vector<std::uint32_t> m_stamp;
    std::uint32_t m_round = 0;
    std::vector<float> m_arc;
    std::vector<std::uint32_t> m_fixed;
};

/// Parts of a tree whose bark can be assigned at the same time, after that of the nodes below them.
struct BarkParts {
    std::vector<std::uint32_t> below; ///< Nodes that carry much, bases first
    std::vector<std::vector<std::uint32_t>>
        branches; ///< The nodes of each branch above them, from its base on
};

BarkParts barkParts(const StrandSkeleton& skeleton, const StrandSections& sections)
{
    const std::size_t count = skeleton.nodes.size();
    std::vector<std::uint64_t> vertices(count, 0); // Of a node and all above it
    std::uint64_t total = 0;
    for (std::size_t i = count; i-- > 0;) {
        const auto node = static_cast<std::uint32_t>(i);
        vertices[i] += sections.block(node).count;
        total += sections.block(node).count;
        if (!skeleton.isBase(node))
            vertices[skeleton.nodes[i].parent] += vertices[i];
    }
    BarkParts parts;
    constexpr std::uint32_t kBelow = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> part(count, kBelow);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t parent = skeleton.nodes[i].parent;
        if (parent != i && part[parent] != kBelow) {
            part[i] = part[parent];
        } else if (vertices[i] * kParts > total) {
            parts.below.push_back(i);
            continue;
        } else {
            part[i] = static_cast<std::uint32_t>(parts.branches.size());
            parts.branches.emplace_back();
        }
        parts.branches[part[i]].push_back(i);
    }
    return parts;
}

} // namespace

void barkStrands(const StrandLayouts& layouts, const StrandTubes& tubes, const StrandSections& sections,
                 const TreeParameters& parameters, BranchMesh& mesh)
{
    std::vector<float> repeats(tubes.nodes.size(), 1.0F);
    tbb::enumerable_thread_specific<BarkCoordinates> coordinates(
        [&] { return BarkCoordinates(layouts, tubes, sections, parameters, mesh, repeats); });
    const BarkParts parts = barkParts(layouts.skeleton(), sections);
    coordinates.local().assign(parts.below);
    parallelFor(parts.branches.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            coordinates.local().assign(parts.branches[i]);
    });
}

} // namespace espalier

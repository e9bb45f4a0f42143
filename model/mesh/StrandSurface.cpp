// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandSurface.h"

#include "model/base/Parallel.h"

#include <cmath>

namespace espalier {

namespace {

using Slice = StrandSections::Slice;
using Loop = StrandSections::Loop;

constexpr std::size_t kNodesPerTask = 64;

/// Sets what belongs to the vertices of one node, from the triangles around them.
class NodeOrientation {
public:
    NodeOrientation(const StrandLayouts& layouts, const StrandSections& sections,
                    const StrandTriangles& triangles, BranchMesh& mesh)
        : m_skeleton(layouts.skeleton()), m_sections(sections), m_triangles(triangles), m_mesh(mesh)
    {
    }

    void orient(std::uint32_t node)
    {
        const StrandSections::Block& block = m_sections.block(node);
        m_first = block.first;
        m_isBase = m_skeleton.isBase(node);
        m_endOfFoot = m_isBase ? endOf(block.whole.front()) - block.first : 0;
        m_sums.assign(block.count, Vec3(Vec3::Zero()));
        const StrandTriangles::Node& own = m_triangles.nodes[node];
        add(own.first, own.count, block);
        for (const std::uint32_t child : m_skeleton.childrenOf(node)) {
            const StrandTriangles::Node& above = m_triangles.nodes[child];
            add(above.first, above.toBelow, block);
        }
        if (!m_skeleton.isBase(node)) {
            const StrandTriangles::Node& below = m_triangles.nodes[m_skeleton.nodes[node].parent];
            add(below.first + below.count - below.toAbove, below.toAbove, block);
        }
        for (std::uint32_t i = 0; i < block.count; ++i) {
            const float length = m_sums[i].norm();
            m_mesh.vertices[m_first + i].normal = toArray(length > 0.0F ? Vec3(m_sums[i] / length) : up());
        }
        setTangents(block);
    }

private:
    static VertexIndex endOf(const Slice& slice)
    {
        return slice.loops.back().first + slice.loops.back().count;
    }

    /// Whether a triangle closes a trunk toward the ground: the bark at its edge must not look downward.
    bool isSole(std::span<const VertexIndex> corners, const StrandSections::Block& block) const
    {
        return m_isBase && std::ranges::all_of(corners, [&](VertexIndex i) {
                   return i - m_first < m_endOfFoot || (block.hasApex && i == block.apex);
               });
    }

    /// Adds the normals of triangles to the vertices of the node.
    void add(std::uint32_t first, std::uint32_t count, const StrandSections::Block& block)
    {
        const auto size = static_cast<VertexIndex>(m_sums.size());
        for (std::size_t t = first; t < std::size_t{first} + count; ++t) {
            const std::array corners{m_mesh.indices[3 * t], m_mesh.indices[3 * t + 1],
                                     m_mesh.indices[3 * t + 2]};
            // Numbers below the first one wrap around, and are great.
            if (std::ranges::none_of(corners, [&](VertexIndex i) { return i - m_first < size; }))
                continue;
            const bool isOfSole = isSole(corners, block);
            const Vec3 p = m_sections.position(corners[0]);
            const Vec3 normal =
                (m_sections.position(corners[1]) - p).cross(m_sections.position(corners[2]) - p);
            for (const VertexIndex corner : corners) {
                if (corner - m_first < size && !(isOfSole && corner - m_first < m_endOfFoot))
                    m_sums[corner - m_first] += normal;
            }
        }
    }

    void setTangents(const StrandSections::Block& block)
    {
        setLoops(block.slices);
        setLoops(block.whole);
        if (block.hasApex) {
            const Loop& loop = block.top().loops.front();
            setTangent(block.apex, m_sections.position(loop.first + 1) - m_sections.position(loop.first));
        }
    }
    void setLoops(std::span<const Slice> slices)
    {
        for (const Slice& slice : slices) {
            for (const Loop& loop : slice.loops) {
                for (std::uint32_t i = 0; i < loop.count; ++i)
                    setTangent(loop.first + i,
                               m_sections.position(loop.first + (i + 1) % loop.count) -
                                   m_sections.position(loop.first + (i + loop.count - 1) % loop.count));
            }
        }
    }
    void setTangent(VertexIndex vertex, const Vec3& along)
    {
        MeshVertex& v = m_mesh.vertices[vertex];
        const Vec3 normal = toVec3(v.normal);
        Vec3 tangent = along - normal.dot(along) * normal;
        const float length = tangent.norm();
        tangent = length > 1e-9F ? Vec3(tangent / length) : anyPerpendicular(normal);
        v.tangent = {tangent.x(), tangent.y(), tangent.z(), -1.0F};
    }

    const StrandSkeleton& m_skeleton;
    const StrandSections& m_sections;
    const StrandTriangles& m_triangles;
    BranchMesh& m_mesh;
    VertexIndex m_first = 0;
    bool m_isBase = false;
    VertexIndex m_endOfFoot = 0; ///< Of the outline at the ground, from m_first on
    std::vector<Vec3> m_sums;
};

/// A vertex of a triangle whose u is by a whole number of turns from that of the triangle's first vertex.
struct Double {
    VertexIndex vertex;
    float turns;
    bool operator==(const Double&) const = default;
};

} // namespace

std::vector<std::uint8_t> nodesNear(std::span<const RaisedVertex> raised, const StrandLayouts& layouts,
                                    const StrandSections& sections)
{
    const StrandSkeleton& skeleton = layouts.skeleton();
    std::vector<std::uint8_t> isNear(skeleton.nodes.size(), 0);
    std::uint32_t node = 0;
    for (const RaisedVertex& vertex : raised) {
        while (vertex.vertex >= sections.block(node).first + sections.block(node).count)
            ++node;
        // A triangle at a node reaches to the node below, and to all nodes that stand on that one.
        const std::uint32_t below = skeleton.nodes[node].parent;
        isNear[node] = isNear[below] = 1;
        for (const std::uint32_t of : {node, below}) {
            for (const std::uint32_t child : skeleton.childrenOf(of))
                isNear[child] = 1;
        }
    }
    return isNear;
}

void orientStrands(const StrandLayouts& layouts, const StrandSections& sections,
                   const StrandTriangles& triangles, const StrandReuse& reuse,
                   std::span<const std::uint8_t> isChanged, WorkProgress& progress, BranchMesh& mesh)
{
    WorkCount oriented(progress, triangles.nodes.size());
    parallelFor(triangles.nodes.size(), kNodesPerTask, [&](std::size_t begin, std::size_t end) {
        if (progress.isCancelled())
            return;
        NodeOrientation orientation(layouts, sections, triangles, mesh);
        for (std::size_t i = begin; i < end; ++i) {
            if (const auto node = static_cast<std::uint32_t>(i);
                isChanged[i] != 0 || !reuse.has(node, StrandReach::Normals))
                orientation.orient(node);
        }
        oriented.add(end - begin);
    });
}

std::vector<VertexIndex> splitSeams(const StrandTriangles& triangles, BranchMesh& mesh)
{
    const std::size_t count = triangles.nodes.size();
    const std::size_t chunks = (count + kNodesPerTask - 1) / kNodesPerTask;
    const auto chunkEnd = [&](std::size_t chunk) { return std::min((chunk + 1) * kNodesPerTask, count); };
    std::vector<std::vector<Double>> doubles(chunks);
    // Until all doubles are counted, the indices of the doubles of a chunk start from this number.
    const auto total = static_cast<VertexIndex>(mesh.vertices.size());
    parallelFor(chunks, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            std::vector<Double>& made = doubles[c];
            for (std::size_t node = c * kNodesPerTask; node < chunkEnd(c); ++node) {
                const auto ofNode = static_cast<std::ptrdiff_t>(made.size());
                const StrandTriangles::Node& n = triangles.nodes[node];
                for (std::size_t i = 3 * std::size_t{n.first}; i < 3 * (std::size_t{n.first} + n.count);
                     i += 3) {
                    const float u = mesh.vertices[mesh.indices[i]].uv[0];
                    for (std::size_t k = 1; k < 3; ++k) {
                        VertexIndex& index = mesh.indices[i + k];
                        const Double wanted{index, std::round(u - mesh.vertices[index].uv[0])};
                        if (wanted.turns == 0.0F)
                            continue;
                        auto found = std::find(made.begin() + ofNode, made.end(), wanted);
                        if (found == made.end())
                            found = made.insert(found, wanted);
                        index = total + static_cast<VertexIndex>(found - made.begin());
                    }
                }
            }
        }
    });
    std::vector<VertexIndex> first(chunks + 1, 0);
    for (std::size_t c = 0; c < chunks; ++c)
        first[c + 1] = first[c] + static_cast<VertexIndex>(doubles[c].size());
    std::vector<VertexIndex> doubled(first.back());
    mesh.vertices.resize(total + first.back());
    mesh.origins.resize(total + first.back());
    parallelFor(chunks, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            for (std::size_t i = 0; i < doubles[c].size(); ++i) {
                const auto& [vertex, turns] = doubles[c][i];
                doubled[first[c] + i] = vertex;
                MeshVertex& copy = mesh.vertices[total + first[c] + i];
                copy = mesh.vertices[vertex];
                copy.uv[0] += turns;
                mesh.origins[total + first[c] + i] = mesh.origins[vertex];
            }
            const StrandTriangles::Node& from = triangles.nodes[c * kNodesPerTask];
            const StrandTriangles::Node& to = triangles.nodes[chunkEnd(c) - 1];
            for (std::size_t i = 3 * std::size_t{from.first}; i < 3 * (std::size_t{to.first} + to.count);
                 ++i) {
                if (mesh.indices[i] >= total)
                    mesh.indices[i] += first[c];
            }
        }
    });
    return doubled;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandMesher.h"

#include "model/base/Parallel.h"
#include "model/mesh/FlatTriangles.h"
#include "model/mesh/LoopStrip.h"
#include "model/mesh/PlanarPatch.h"
#include "model/mesh/StrandBark.h"
#include "model/mesh/StrandSections.h"
#include "model/mesh/StrandTubes.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {

namespace {

constexpr std::size_t kBlocksPerTask = 64;
/// Outlines in the plane of a patch, in strand radii: how far the outline of the whole lies outside its
/// strands, and those of the parts; the radius of a ring.
constexpr float kWholeMargin = 0.8F;
constexpr float kPartMargin = 0.3F;
constexpr float kRingInPlane = 0.5F;

/// Makes the triangles of all nodes.
class StrandTriangulation {
public:
    using Triangle = std::array<VertexIndex, 3>;

    StrandTriangulation(const StrandLayouts& layouts, const StrandTubes& tubes,
                        const StrandSections& sections)
        : m_layouts(layouts),
          m_skeleton(layouts.skeleton()),
          m_tubes(tubes),
          m_sections(sections),
          m_ofNodes(layouts.skeleton().nodes.size())
    {
    }

    MeshBuffer<VertexIndex> make()
    {
        parallelFor(m_ofNodes.size(), kBlocksPerTask, [&](std::size_t begin, std::size_t end) {
            Scratch& scratch = m_scratch.local();
            for (std::size_t i = begin; i < end; ++i)
                makeNode(static_cast<std::uint32_t>(i), scratch);
        });
        std::vector<std::size_t> first(m_ofNodes.size() + 1, 0);
        for (std::size_t i = 0; i < m_ofNodes.size(); ++i)
            first[i + 1] = first[i] + 3 * m_ofNodes[i].size();
        MeshBuffer<VertexIndex> indices(first.back());
        parallelFor(m_ofNodes.size(), kBlocksPerTask, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                auto* place = indices.data() + first[i];
                for (const Triangle& triangle : m_ofNodes[i])
                    place = std::ranges::copy(triangle, place).out;
            }
        });
        return indices;
    }

private:
    struct Scratch {
        LoopStrip strip;
        PlanarPatch patch;
        PlanarPatch::Triangles planar;
        std::vector<PlanarPatch::Outline> whole;
        std::vector<PlanarPatch::Outline> parts;
        std::vector<VertexIndex> numbers; ///< Of the patch's points
    };

    void makeNode(std::uint32_t node, Scratch& scratch)
    {
        std::vector<Triangle>& triangles = m_ofNodes[node];
        const StrandTubes::Node& n = m_tubes.nodes[node];
        const StrandSections::Block& block = m_sections.block(node);
        for (std::size_t tube = 0; tube < n.tubes.size(); ++tube) {
            std::span<const StrandSections::Slice> slices = block.slicesOf(tube);
            if (const std::uint32_t below = m_skeleton.nodes[node].parent;
                m_tubes.nodes[below].continuesAbove)
                joinSlices(m_sections.block(below).top(),
                           slices.empty() ? block.whole.front() : slices.front(),
                           m_skeleton.nodes[node].offset, scratch, triangles);
            for (std::size_t i = 0; i + 1 < slices.size(); ++i)
                joinSlices(slices[i], slices[i + 1], 0, scratch, triangles);
            if (n.continuesBelow && !slices.empty())
                joinSlices(slices.back(), block.whole.front(), 0, scratch, triangles);
        }
        if (!n.continuesBelow)
            patchBelow(node, scratch, triangles);
        for (std::size_t i = 0; i + 1 < block.whole.size(); ++i)
            joinSlices(block.whole[i], block.whole[i + 1], 0, scratch, triangles);
        if (m_skeleton.isBase(node))
            closeBase(node, scratch, triangles);
        if (m_skeleton.nodes[node].childCount == 0)
            closeTip(block, triangles);
        else if (!n.continuesAbove)
            patchAbove(node, scratch, triangles);
    }

    /// Joins the loops of two slices of one bundle. Strands of the lower one have numbers greater by @p
    /// offset.
    void joinSlices(const StrandSections::Slice& lower, const StrandSections::Slice& upper,
                    std::uint32_t offset, Scratch& scratch, std::vector<Triangle>& triangles)
    {
        const auto position = [&](VertexIndex vertex) { return m_sections.position(vertex); };
        const auto loopOf = [&](const StrandSections::Loop& loop, std::uint32_t shift,
                                std::vector<std::uint32_t>& shifted) {
            std::span<const std::uint32_t> strands = m_sections.strands(loop);
            if (shift > 0) {
                shifted.assign(strands.begin(), strands.end());
                for (std::uint32_t& strand : shifted)
                    strand -= shift;
                strands = shifted;
            }
            return VertexLoop{loop.first, loop.count, strands};
        };
        std::vector<std::uint32_t> shifted;
        // The first loops go around the wood; cavities are matched by the strands that they share.
        scratch.strip.join(loopOf(lower.loops.front(), offset, shifted),
                           loopOf(upper.loops.front(), 0, shifted), position, triangles);
        std::vector<bool> isMatched(upper.loops.size(), false);
        for (std::size_t i = 1; i < lower.loops.size(); ++i) {
            const VertexLoop low = loopOf(lower.loops[i], offset, shifted);
            std::size_t match = 0;
            for (std::size_t j = 1; j < upper.loops.size() && match == 0; ++j) {
                const std::span<const std::uint32_t> there = m_sections.strands(upper.loops[j]);
                if (!isMatched[j] && std::ranges::any_of(low.strands, [&](std::uint32_t strand) {
                        return std::ranges::find(there, strand) != there.end();
                    }))
                    match = j;
            }
            if (match == 0) {
                capCavity(lower.loops[i], true, scratch, triangles);
                continue;
            }
            isMatched[match] = true;
            std::vector<std::uint32_t> none;
            scratch.strip.join(low, loopOf(upper.loops[match], 0, none), position, triangles);
        }
        for (std::size_t j = 1; j < upper.loops.size(); ++j) {
            if (!isMatched[j])
                capCavity(upper.loops[j], false, scratch, triangles);
        }
    }

    /// Closes a cavity at its upper end, or at its lower one.
    void capCavity(const StrandSections::Loop& loop, bool isUpperEnd, Scratch& scratch,
                   std::vector<Triangle>& triangles)
    {
        // Seen from inside the cavity the loop is the outline of a hollow: in the plane it runs clockwise.
        scratch.whole.resize(1);
        scratch.parts.clear();
        PlanarPatch::Outline& outline = scratch.whole.front();
        outline.strands.clear();
        outline.points = m_sections.plane(loop);
        std::ranges::reverse(outline.points);
        scratch.patch.triangulate(scratch.whole, scratch.parts, scratch.planar);
        for (const auto& [a, b, c] : scratch.planar) {
            const auto vertex = [&](std::uint32_t i) { return loop.first + (loop.count - 1 - i); };
            if (isUpperEnd)
                triangles.push_back({vertex(a), vertex(b), vertex(c)});
            else
                triangles.push_back({vertex(a), vertex(c), vertex(b)});
        }
    }

    /// Adds an outline in the plane of the section of @p node.
    void addOutline(const StrandSections::Loop& loop, std::span<const Vec2> places, std::uint32_t offset,
                    float margin, Scratch& scratch, std::vector<PlanarPatch::Outline>& outlines) const
    {
        PlanarPatch::Outline& outline = outlines.emplace_back();
        const std::span<const std::uint32_t> strands = m_sections.strands(loop);
        const std::size_t count = strands.size();
        for (std::size_t i = 0; i < count; ++i) {
            outline.strands.push_back(strands[i] + offset);
            const Vec2& place = places[strands[i] + offset];
            Vec2 along =
                places[strands[(i + 1) % count] + offset] - places[strands[(i + count - 1) % count] + offset];
            const float length = along.norm();
            along = length > 1e-6F ? Vec2(along / length) : Vec2(1.0F, 0.0F);
            outline.points.emplace_back(place + margin * Vec2(along.y(), -along.x()));
        }
        for (std::uint32_t i = 0; i < loop.count; ++i)
            scratch.numbers.push_back(loop.first + i);
    }
    static void addRing(const StrandSections::Loop& loop, const Vec2& centre, float radius, Scratch& scratch,
                        std::vector<PlanarPatch::Outline>& outlines)
    {
        PlanarPatch::Outline& outline = outlines.emplace_back();
        for (std::uint32_t i = 0; i < loop.count; ++i) {
            const float angle =
                2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(loop.count);
            outline.points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
            scratch.numbers.push_back(loop.first + i);
        }
    }

    void addWhole(const StrandSections::Slice& slice, std::uint32_t node, std::span<const Vec2> places,
                  Scratch& scratch) const
    {
        if (m_tubes.nodes[node].whole.isRing()) {
            float radius = 0.0F;
            for (const Vec2& place : places)
                radius = std::max(radius, place.norm());
            addRing(slice.loops.front(), Vec2::Zero(), radius + 4.0F * kWholeMargin, scratch, scratch.whole);
            return;
        }
        for (const StrandSections::Loop& loop : slice.loops)
            addOutline(loop, places, 0, kWholeMargin, scratch, scratch.whole);
    }

    void addPart(const StrandSections::Slice& slice, const StrandTube& tube, std::uint32_t strandCount,
                 std::uint32_t offset, std::span<const Vec2> places, Scratch& scratch) const
    {
        if (!m_sections.strands(slice.loops.front()).empty()) {
            for (const StrandSections::Loop& loop : slice.loops)
                addOutline(loop, places, offset, kPartMargin, scratch, scratch.parts);
            return;
        }
        Vec2 centre = Vec2::Zero();
        const auto count =
            tube.strands.empty() ? strandCount : static_cast<std::uint32_t>(tube.strands.size());
        for (std::uint32_t i = 0; i < count; ++i)
            centre +=
                places[offset + (tube.strands.empty() ? i : tube.strands[i])] / static_cast<float>(count);
        addRing(slice.loops.front(), centre, kRingInPlane, scratch, scratch.parts);
    }

    void triangulate(bool facesUp, Scratch& scratch, std::vector<Triangle>& triangles)
    {
        scratch.patch.triangulate(scratch.whole, scratch.parts, scratch.planar);
        // Counter-clockwise in the coordinates of the section is clockwise seen from above.
        for (const auto& [a, b, c] : scratch.planar) {
            if (facesUp)
                triangles.push_back({scratch.numbers[a], scratch.numbers[c], scratch.numbers[b]});
            else
                triangles.push_back({scratch.numbers[a], scratch.numbers[b], scratch.numbers[c]});
        }
    }

    std::span<const Vec2> placesOf(std::uint32_t node) const { return m_layouts.unturned(node); }

    void patchAbove(std::uint32_t node, Scratch& scratch, std::vector<Triangle>& triangles)
    {
        scratch.whole.clear();
        scratch.parts.clear();
        scratch.numbers.clear();
        addWhole(m_sections.block(node).top(), node, placesOf(node), scratch);
        for (const std::uint32_t child : m_skeleton.childrenOf(node)) {
            const StrandNode& c = m_skeleton.nodes[child];
            for (std::size_t tube = 0; tube < m_tubes.nodes[child].tubes.size(); ++tube)
                addPart(m_sections.block(child).slicesOf(tube).front(), m_tubes.nodes[child].tubes[tube],
                        c.strands, c.offset, placesOf(node), scratch);
        }
        triangulate(true, scratch, triangles);
    }

    void patchBelow(std::uint32_t node, Scratch& scratch, std::vector<Triangle>& triangles)
    {
        scratch.whole.clear();
        scratch.parts.clear();
        scratch.numbers.clear();
        addWhole(m_sections.block(node).whole.front(), node, placesOf(node), scratch);
        for (std::size_t tube = 0; tube < m_tubes.nodes[node].tubes.size(); ++tube)
            addPart(m_sections.block(node).slicesOf(tube).back(), m_tubes.nodes[node].tubes[tube],
                    m_skeleton.nodes[node].strands, 0, placesOf(node), scratch);
        triangulate(false, scratch, triangles);
    }

    void closeBase(std::uint32_t node, Scratch& scratch, std::vector<Triangle>& triangles)
    {
        if (const StrandSections::Block& block = m_sections.block(node); block.hasApex) {
            const StrandSections::Loop& loop = block.whole.front().loops.front();
            for (std::uint32_t i = 0; i < loop.count; ++i)
                triangles.push_back({loop.first + i, loop.first + (i + 1) % loop.count, block.apex});
            return;
        }
        scratch.whole.clear();
        scratch.parts.clear();
        scratch.numbers.clear();
        addWhole(m_sections.block(node).whole.front(), node, placesOf(node), scratch);
        triangulate(false, scratch, triangles);
    }

    static void closeTip(const StrandSections::Block& block, std::vector<Triangle>& triangles)
    {
        const StrandSections::Loop& loop = block.top().loops.front();
        for (std::uint32_t i = 0; i < loop.count; ++i)
            triangles.push_back({loop.first + i, block.apex, loop.first + (i + 1) % loop.count});
    }

    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
    const StrandTubes& m_tubes;
    const StrandSections& m_sections;
    std::vector<std::vector<Triangle>> m_ofNodes;
    tbb::enumerable_thread_specific<Scratch> m_scratch;
};

/// Removes surfaces that enclose no wood: those of cavities that are closed on all sides, which are not seen,
/// and scraps of strands that stray between parts.
void removeVoids(MeshBuffer<VertexIndex>& indices, const MeshBuffer<MeshVertex>& vertices)
{
    std::vector<VertexIndex> root(vertices.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](VertexIndex i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        for (std::size_t k = 1; k < 3; ++k) {
            const VertexIndex a = find(indices[i]);
            const VertexIndex b = find(indices[i + k]);
            root[std::max(a, b)] = std::min(a, b);
        }
    }
    std::vector<double> volumes(vertices.size(), 0.0);
    const auto at = [&](std::size_t i) -> Eigen::Vector3d {
        return toVec3(vertices[indices[i]].position).cast<double>();
    };
    for (std::size_t i = 0; i < indices.size(); i += 3)
        volumes[find(indices[i])] += at(i).dot(at(i + 1).cross(at(i + 2)));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        if (volumes[find(indices[i])] < 0.0)
            continue;
        for (std::size_t k = 0; k < 3; ++k)
            indices[kept++] = indices[i + k];
    }
    indices.resize(kept);
}

bool mayHaveVoids(const StrandTubes& tubes)
{
    const auto hasCavity = [](const BundleOutline& outline) {
        return std::ranges::any_of(outline.loops, &SectionLoop::isCavity);
    };
    return std::ranges::any_of(tubes.nodes, [&](const StrandTubes::Node& node) {
        return !node.continuesBelow || hasCavity(node.whole) ||
               std::ranges::any_of(node.tubes, [&](const StrandTube& tube) {
                   return hasCavity(tube.below) || hasCavity(tube.above);
               });
    });
}

} // namespace

BranchMesh meshStrands(const StrandLayouts& layouts, const TreeParameters& parameters,
                       const WoodMeshOptions& options)
{
    const StrandTubes tubes = strandTubes(layouts, parameters.wood, options);
    const StrandSections sections(layouts, tubes, parameters);
    BranchMesh mesh;
    mesh.indices = StrandTriangulation(layouts, tubes, sections).make();
    if (mayHaveVoids(tubes))
        removeVoids(mesh.indices, sections.vertices());
    mesh.vertices = sections.vertices();
    raiseFlatTriangles(mesh.indices, mesh.vertices);
    mesh.origins = sections.origins();
    dressStrands(layouts, tubes, sections, parameters, mesh);
    return mesh;
}

} // namespace espalier

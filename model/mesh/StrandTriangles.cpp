// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandTriangles.h"

#include "model/base/LargePages.h"
#include "model/base/Parallel.h"
#include "model/mesh/LoopStrip.h"
#include "model/mesh/PlanarPatch.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {

namespace {

/// Volume against area to the power of 1.5 of surfaces that are the bark of something; a thin twig has more.
constexpr double kLeastCompactness = 1e-6;

constexpr std::size_t kNodesPerChunk = 64;
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
                        const StrandSections& sections, const StrandReuse& reuse,
                        const StrandSections::Last& last, const StrandTriangles* lastTriangles,
                        WorkProgress& progress)
        : m_layouts(layouts),
          m_skeleton(layouts.skeleton()),
          m_tubes(tubes),
          m_sections(sections),
          m_reuse(reuse),
          m_last(last),
          m_lastTriangles(lastTriangles),
          m_progress(progress)
    {
    }

    StrandTriangles make(MeshBuffer<VertexIndex>& indices)
    {
        const std::size_t count = m_skeleton.nodes.size();
        StrandTriangles result;
        result.nodes.resize(count);
        m_chunks.resize((count + kNodesPerChunk - 1) / kNodesPerChunk);
        WorkCount done(m_progress, m_chunks.size());
        forEachNode(
            [&](std::uint32_t node, Chunk& chunk) {
                StrandTriangles::Node& made = result.nodes[node];
                if (isTaken(node)) {
                    made = m_lastTriangles->nodes[m_reuse.before(node)];
                    return;
                }
                const std::size_t links = chunk.links.size();
                makeNode(node, m_scratch.local(), chunk, made);
                made.linkCount = static_cast<std::uint32_t>(chunk.links.size() - links);
            },
            &done);
        std::uint32_t first = 0;
        std::uint32_t firstLink = 0;
        for (StrandTriangles::Node& node : result.nodes) {
            node.first = std::exchange(first, first + node.count);
            node.firstLink = std::exchange(firstLink, firstLink + node.linkCount);
        }
        indices.reserve(3 * std::size_t{first});
        wantLargePages(indices.data(), indices.capacity() * sizeof(VertexIndex));
        indices.resize(3 * std::size_t{first});
        result.links.resize(firstLink);
        for (Chunk& chunk : m_chunks)
            chunk.written = chunk.writtenLinks = 0;
        forEachNode([&](std::uint32_t node, Chunk& chunk) {
            const StrandTriangles::Node& made = result.nodes[node];
            if (isTaken(node)) {
                take(node, made, indices, result.links);
                return;
            }
            auto* place = indices.data() + 3 * std::size_t{made.first};
            for (const Triangle& triangle :
                 std::span<const Triangle>(chunk.triangles).subspan(chunk.written, made.count))
                place = std::ranges::copy(triangle, place).out;
            std::ranges::copy(std::span<const StrandTriangles::Link>(chunk.links)
                                  .subspan(chunk.writtenLinks, made.linkCount),
                              result.links.begin() + made.firstLink);
            chunk.written += made.count;
            chunk.writtenLinks += made.linkCount;
        });
        return result;
    }

private:
    /// What is made for the nodes of one part of the tree, one after another.
    struct Chunk {
        std::vector<Triangle> triangles;
        std::vector<StrandTriangles::Link> links;
        std::size_t written = 0;
        std::size_t writtenLinks = 0;
    };
    struct Scratch {
        LoopStrip strip;
        PlanarPatch patch;
        PlanarPatch::Triangles planar;
        std::vector<PlanarPatch::Outline> whole;
        std::vector<PlanarPatch::Outline> parts;
        std::vector<VertexIndex> numbers; ///< Of the patch's points
        std::vector<VertexIndex> loops;   ///< The first vertex of the outline of each of them
        std::vector<std::uint32_t> shifted;

        void begin()
        {
            whole.clear();
            parts.clear();
            numbers.clear();
            loops.clear();
        }
    };

    /// Counts chunks that are done.
    template <class Work>
    void forEachNode(Work&& work, WorkCount* done = nullptr)
    {
        parallelFor(m_chunks.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end && !m_progress.isCancelled(); ++c) {
                const std::size_t last = std::min((c + 1) * kNodesPerChunk, m_skeleton.nodes.size());
                for (std::size_t i = c * kNodesPerChunk; i < last; ++i)
                    work(static_cast<std::uint32_t>(i), m_chunks[c]);
                if (done != nullptr)
                    done->add(1);
            }
        });
    }

    bool isTaken(std::uint32_t node) const
    {
        return m_reuse.has(node, StrandReach::Triangles) &&
               !m_lastTriangles->nodes[m_reuse.before(node)].isIncomplete;
    }

    /// Copies a node's triangles from the last mesh; its vertices and those of its neighbours have moved in
    /// the order of vertices.
    void take(std::uint32_t node, const StrandTriangles::Node& made, MeshBuffer<VertexIndex>& indices,
              std::vector<StrandTriangles::Link>& links) const
    {
        const std::uint32_t old = m_reuse.before(node);
        const StrandSkeleton& oldSkeleton = m_reuse.lastSkeleton();
        struct Move {
            VertexIndex begin;
            VertexIndex end;
            VertexIndex shift; ///< Modulo 2^32
        };
        std::array<Move, 8> few;
        std::vector<Move> many;
        const auto children = m_skeleton.childrenOf(node);
        const auto oldChildren = oldSkeleton.childrenOf(old);
        std::span<Move> moves(few);
        if (children.size() + 2 > few.size()) {
            many.resize(children.size() + 2);
            moves = many;
        }
        std::size_t count = 0;
        const auto add = [&](std::uint32_t before, std::uint32_t now) {
            const StrandSections::Block& block = (*m_last.blocks)[before];
            moves[count++] = {block.first, block.first + block.count,
                              m_sections.block(now).first - block.first};
        };
        add(old, node);
        add(oldSkeleton.nodes[old].parent, m_skeleton.nodes[node].parent);
        for (std::size_t i = 0; i < children.size(); ++i)
            add(oldChildren[i], children[i]);
        moves = moves.first(count);
        const auto firstDouble =
            static_cast<VertexIndex>(m_last.mesh->vertices.size() - m_lastTriangles->doubled.size());
        const auto moved = [&](VertexIndex vertex) {
            if (vertex >= firstDouble)
                vertex = m_lastTriangles->doubled[vertex - firstDouble];
            for (const Move& move : moves) {
                if (vertex >= move.begin && vertex < move.end)
                    return vertex + move.shift;
            }
            return vertex; // Not reached: triangles have vertices of these blocks alone
        };
        const StrandTriangles::Node& before = m_lastTriangles->nodes[old];
        std::transform(m_last.mesh->indices.begin() + 3 * std::ptrdiff_t{before.first},
                       m_last.mesh->indices.begin() +
                           3 * (std::ptrdiff_t{before.first} + std::ptrdiff_t{before.count}),
                       indices.begin() + 3 * std::ptrdiff_t{made.first}, moved);
        for (std::uint32_t i = 0; i < made.linkCount; ++i) {
            const auto& [a, b] = m_lastTriangles->links[before.firstLink + i];
            links[made.firstLink + i] = {moved(a), moved(b)};
        }
    }

    void makeNode(std::uint32_t node, Scratch& scratch, Chunk& made, StrandTriangles::Node& counts)
    {
        const std::size_t before = made.triangles.size();
        const auto sinceBefore = [&] { return static_cast<std::uint32_t>(made.triangles.size() - before); };
        const StrandTubes::Node& n = m_tubes.nodes[node];
        const StrandSections::Block& block = m_sections.block(node);
        if (const std::uint32_t below = m_skeleton.nodes[node].parent; m_tubes.nodes[below].continuesAbove) {
            for (std::size_t tube = 0; tube < n.tubes.size(); ++tube) {
                const std::span<const StrandSections::Slice> slices = block.slicesOf(tube);
                joinSlices(m_sections.block(below).top(),
                           slices.empty() ? block.whole.front() : slices.front(),
                           m_skeleton.nodes[node].offset, scratch, made);
            }
        }
        counts.toBelow = sinceBefore();
        for (std::size_t tube = 0; tube < n.tubes.size(); ++tube) {
            const std::span<const StrandSections::Slice> slices = block.slicesOf(tube);
            for (std::size_t i = 0; i + 1 < slices.size(); ++i)
                joinSlices(slices[i], slices[i + 1], 0, scratch, made);
            if (n.continuesBelow && !slices.empty())
                joinSlices(slices.back(), block.whole.front(), 0, scratch, made);
        }
        if (!n.continuesBelow)
            patchBelow(node, scratch, made);
        for (std::size_t i = 0; i + 1 < block.whole.size(); ++i)
            joinSlices(block.whole[i], block.whole[i + 1], 0, scratch, made);
        if (m_skeleton.isBase(node))
            closeBase(node, scratch, made);
        const std::uint32_t own = sinceBefore();
        if (m_skeleton.nodes[node].childCount == 0)
            closeTip(block, made);
        else if (!n.continuesAbove)
            patchAbove(node, scratch, made);
        counts.count = sinceBefore();
        counts.toAbove = m_skeleton.nodes[node].childCount == 0 ? 0 : counts.count - own;
    }

    /// Joins the loops of two slices of one bundle. Strands of the lower one have numbers greater by @p
    /// offset.
    void joinSlices(const StrandSections::Slice& lower, const StrandSections::Slice& upper,
                    std::uint32_t offset, Scratch& scratch, Chunk& made)
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
        std::vector<std::uint32_t>& shifted = scratch.shifted;
        // The first loops go around the wood; cavities are matched by the strands that they share.
        scratch.strip.join(loopOf(lower.loops.front(), offset, shifted),
                           loopOf(upper.loops.front(), 0, shifted), position, made.triangles);
        made.links.push_back({lower.loops.front().first, upper.loops.front().first});
        if (lower.loops.size() > 1 || upper.loops.size() > 1)
            joinCavities(lower, upper, offset, scratch, made);
    }

    void joinCavities(const StrandSections::Slice& lower, const StrandSections::Slice& upper,
                      std::uint32_t offset, Scratch& scratch, Chunk& made)
    {
        const auto position = [&](VertexIndex vertex) { return m_sections.position(vertex); };
        std::vector<std::vector<std::uint32_t>> shifted;
        std::vector<std::span<const std::uint32_t>> lows;
        std::vector<std::span<const std::uint32_t>> ups;
        for (const StrandSections::Loop& loop : std::span(lower.loops).subspan(1)) {
            const std::span<const std::uint32_t> strands = m_sections.strands(loop);
            for (std::uint32_t& strand : shifted.emplace_back(strands.begin(), strands.end()))
                strand -= offset;
        }
        for (const std::vector<std::uint32_t>& strands : shifted)
            lows.emplace_back(strands);
        for (const StrandSections::Loop& loop : std::span(upper.loops).subspan(1))
            ups.push_back(m_sections.strands(loop));
        const std::vector<std::size_t> matches = matchCavities(lows, ups);
        std::vector<bool> isMatched(ups.size(), false);
        for (std::size_t i = 0; i < lows.size(); ++i) {
            const StrandSections::Loop& low = lower.loops[i + 1];
            if (matches[i] == kNoCavity) {
                capCavity(low, true, scratch, made);
                continue;
            }
            isMatched[matches[i]] = true;
            const StrandSections::Loop& up = upper.loops[matches[i] + 1];
            scratch.strip.join({low.first, low.count, lows[i]}, {up.first, up.count, ups[matches[i]]},
                               position, made.triangles);
            made.links.push_back({low.first, up.first});
        }
        for (std::size_t j = 0; j < ups.size(); ++j) {
            if (!isMatched[j])
                capCavity(upper.loops[j + 1], false, scratch, made);
        }
    }

    /// Closes a cavity at its upper end, or at its lower one.
    void capCavity(const StrandSections::Loop& loop, bool isUpperEnd, Scratch& scratch, Chunk& made)
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
                made.triangles.push_back({vertex(a), vertex(b), vertex(c)});
            else
                made.triangles.push_back({vertex(a), vertex(c), vertex(b)});
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
            addNumber(loop, i, scratch);
    }
    static void addNumber(const StrandSections::Loop& loop, std::uint32_t i, Scratch& scratch)
    {
        scratch.numbers.push_back(loop.first + i);
        scratch.loops.push_back(loop.first);
    }
    static void addRing(const StrandSections::Loop& loop, const Vec2& centre, float radius, Scratch& scratch,
                        std::vector<PlanarPatch::Outline>& outlines)
    {
        PlanarPatch::Outline& outline = outlines.emplace_back();
        for (std::uint32_t i = 0; i < loop.count; ++i) {
            const float angle =
                2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(loop.count);
            outline.points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
            addNumber(loop, i, scratch);
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

    void triangulate(bool facesUp, Scratch& scratch, Chunk& made)
    {
        scratch.patch.triangulate(scratch.whole, scratch.parts, scratch.planar);
        // Counter-clockwise in the coordinates of the section is clockwise seen from above.
        for (const auto& [a, b, c] : scratch.planar) {
            for (const auto& link : {StrandTriangles::Link{scratch.loops[a], scratch.loops[b]},
                                     StrandTriangles::Link{scratch.loops[a], scratch.loops[c]}}) {
                if (link[0] != link[1] && (made.links.empty() || made.links.back() != link))
                    made.links.push_back(link);
            }
            if (facesUp)
                made.triangles.push_back({scratch.numbers[a], scratch.numbers[c], scratch.numbers[b]});
            else
                made.triangles.push_back({scratch.numbers[a], scratch.numbers[b], scratch.numbers[c]});
        }
    }

    std::span<const Vec2> placesOf(std::uint32_t node) const { return m_layouts.places(node); }

    void patchAbove(std::uint32_t node, Scratch& scratch, Chunk& made)
    {
        scratch.begin();
        addWhole(m_sections.block(node).top(), node, placesOf(node), scratch);
        for (const std::uint32_t child : m_skeleton.childrenOf(node)) {
            const StrandNode& c = m_skeleton.nodes[child];
            for (std::size_t tube = 0; tube < m_tubes.nodes[child].tubes.size(); ++tube)
                addPart(m_sections.block(child).slicesOf(tube).front(), m_tubes.nodes[child].tubes[tube],
                        c.strands, c.offset, placesOf(node), scratch);
        }
        triangulate(true, scratch, made);
    }

    void patchBelow(std::uint32_t node, Scratch& scratch, Chunk& made)
    {
        scratch.begin();
        addWhole(m_sections.block(node).whole.front(), node, placesOf(node), scratch);
        for (std::size_t tube = 0; tube < m_tubes.nodes[node].tubes.size(); ++tube)
            addPart(m_sections.block(node).slicesOf(tube).back(), m_tubes.nodes[node].tubes[tube],
                    m_skeleton.nodes[node].strands, 0, placesOf(node), scratch);
        triangulate(false, scratch, made);
    }

    void closeBase(std::uint32_t node, Scratch& scratch, Chunk& made)
    {
        if (const StrandSections::Block& block = m_sections.block(node); block.hasApex) {
            const StrandSections::Loop& loop = block.whole.front().loops.front();
            for (std::uint32_t i = 0; i < loop.count; ++i)
                made.triangles.push_back({loop.first + i, loop.first + (i + 1) % loop.count, block.apex});
            return;
        }
        scratch.begin();
        addWhole(m_sections.block(node).whole.front(), node, placesOf(node), scratch);
        triangulate(false, scratch, made);
    }

    static void closeTip(const StrandSections::Block& block, Chunk& made)
    {
        const StrandSections::Loop& loop = block.top().loops.front();
        for (std::uint32_t i = 0; i < loop.count; ++i)
            made.triangles.push_back({loop.first + i, block.apex, loop.first + (i + 1) % loop.count});
    }

    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
    const StrandTubes& m_tubes;
    const StrandSections& m_sections;
    const StrandReuse& m_reuse;
    const StrandSections::Last& m_last;
    const StrandTriangles* m_lastTriangles;
    WorkProgress& m_progress;
    std::vector<Chunk> m_chunks;
    tbb::enumerable_thread_specific<Scratch> m_scratch;
};

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

/// Removes the triangles for which @p isVoid(first vertex) is true.
template <class IsVoid>
void removeTriangles(StrandTriangles& triangles, MeshBuffer<VertexIndex>& indices, IsVoid&& isVoid)
{
    std::uint32_t kept = 0;
    for (StrandTriangles::Node& node : triangles.nodes) {
        const StrandTriangles::Node before = node;
        node.first = kept;
        for (std::uint32_t t = 0; t < before.count; ++t) {
            const std::size_t from = 3 * (std::size_t{before.first} + t);
            if (isVoid(indices[from])) {
                --node.count;
                node.isIncomplete = true;
                continue;
            }
            std::copy_n(indices.begin() + static_cast<std::ptrdiff_t>(from), 3,
                        indices.begin() + 3 * std::ptrdiff_t{kept++});
        }
    }
    indices.resize(3 * std::size_t{kept});
}

} // namespace

StrandTriangles triangulateStrands(const StrandLayouts& layouts, const StrandTubes& tubes,
                                   const StrandSections& sections, const StrandReuse& reuse,
                                   const StrandSections::Last& last, const StrandTriangles* lastTriangles,
                                   WorkProgress& progress, BranchMesh& mesh)
{
    return StrandTriangulation(layouts, tubes, sections, reuse, last, lastTriangles, progress)
        .make(mesh.indices);
}

void removeVoids(const StrandLayouts& layouts, const StrandTubes& tubes, const StrandSections& sections,
                 StrandTriangles& triangles, BranchMesh& mesh)
{
    if (!mayHaveVoids(tubes))
        return;
    // A loop is connected by its own edges, so its first vertex stands for all of them.
    std::vector<VertexIndex> root(mesh.vertices.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](VertexIndex i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    for (const auto& link : triangles.links) {
        const VertexIndex a = find(link[0]);
        const VertexIndex b = find(link[1]);
        root[std::max(a, b)] = std::min(a, b);
    }
    std::vector<VertexIndex> wood; // What stands on the ground
    for (const std::uint32_t base : layouts.skeleton().bases)
        wood.push_back(find(sections.block(base).whole.front().loops.front().first));
    constexpr VertexIndex kNone = std::numeric_limits<VertexIndex>::max();
    std::vector<VertexIndex> component; // Of the other surfaces, by vertex
    const auto note = [&](std::span<const StrandSections::Slice> slices) {
        for (const StrandSections::Slice& slice : slices) {
            for (const StrandSections::Loop& loop : slice.loops) {
                const VertexIndex surface = find(loop.first);
                if (std::ranges::find(wood, surface) != wood.end())
                    continue;
                component.resize(mesh.vertices.size(), kNone);
                std::fill_n(component.begin() + loop.first, loop.count, surface);
            }
        }
    };
    for (std::uint32_t node = 0; node < tubes.nodes.size(); ++node) {
        note(sections.block(node).slices);
        note(sections.block(node).whole);
    }
    if (component.empty())
        return;
    std::vector<double> volumes(mesh.vertices.size(), 0.0); // Six times
    std::vector<double> areas(mesh.vertices.size(), 0.0);   // Twice
    const auto at = [&](std::size_t i) -> Eigen::Vector3d {
        return toVec3(mesh.vertices[mesh.indices[i]].position).cast<double>();
    };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const VertexIndex surface = component[mesh.indices[i]];
        if (surface == kNone)
            continue;
        volumes[surface] += at(i).dot(at(i + 1).cross(at(i + 2)));
        areas[surface] += (at(i + 1) - at(i)).cross(at(i + 2) - at(i)).norm();
    }
    // A cavity of one section is closed by the same triangles above and below: it has no volume either.
    const auto isVoid = [&](VertexIndex surface) {
        return volumes[surface] <= kLeastCompactness * std::pow(areas[surface], 1.5);
    };
    removeTriangles(triangles, mesh.indices, [&](VertexIndex vertex) {
        return component[vertex] != kNone && isVoid(component[vertex]);
    });
}

} // namespace espalier

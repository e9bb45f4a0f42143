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
/// Of what is uneven in u, 1/e is left after so many perimeters along the branch.
constexpr float kEvenAfter = 0.3F;
/// Bark that is stretched or squeezed more than so much over this share of the outline, as where strands come
/// to the surface between others, evens out sooner.
constexpr float kSoonEvenAfter = 0.06F;
constexpr float kStretchShare = 0.08F;
constexpr float kLeastDensity = 0.7F;
constexpr float kMostDensity = 1.5F;
/// Profiles up to so many times as long as the outline of a round bundle keep the number of repeats.
constexpr float kNearlyRound = 1.5F;
/// Parts of a repeat below this one are left out; so bark is rather finer than coarser than its scale.
constexpr float kSpareRepeat = 0.25F;

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
        m_last.resize(most);
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
    /// How often the texture repeats along @p length, m.
    float repeatsOf(float length) const { return std::max(1.0F, std::ceil(length / m_scale - kSpareRepeat)); }
    static float perimeterOf(float radius) { return 2.0F * std::numbers::pi_v<float> * radius; }

    Vec3 at(VertexIndex vertex) const { return toVec3(m_mesh.vertices[vertex].position); }
    float& u(VertexIndex vertex) { return m_mesh.vertices[vertex].uv[0]; }
    float& v(VertexIndex vertex) { return m_mesh.vertices[vertex].uv[1]; }

    void assignBase(std::uint32_t node)
    {
        const StrandNode& n = m_skeleton.nodes[node];
        const auto above = m_skeleton.childrenOf(node);
        // Without the flare.
        m_repeats[node] =
            repeatsOf(perimeterOf(above.empty() ? n.radius : m_skeleton.nodes[above.front()].radius));
        forget();
        for (const Slice& slice : m_sections.block(node).whole)
            assignSlice(slice, nullptr, 0.0F, node, isOne(node));
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
        m_repeats[node] =
            2 * n.strands >= below.strands ? m_repeats[n.parent] : repeatsOf(perimeterOf(n.radius));
        const bool isWhole = m_tubes.nodes[node].tubes.size() == 1 && m_tubes.nodes[node].continuesBelow;
        float top = 0.0F;
        const Slice* last = &support;
        for (std::size_t tube = 0; tube < m_tubes.nodes[node].tubes.size(); ++tube) {
            last = &support;
            forget();
            learn(support, n.offset);
            for (const Slice& slice : block.slicesOf(tube)) {
                assignSlice(slice, last, v(last->loops.front().first), node, isWhole);
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
            assignSlice(slice, last, top, node, isOne(node));
            learn(slice, 0);
            last = &slice;
            top = v(slice.loops.front().first);
        }
        if (n.childCount == 0) {
            u(block.apex) = u(last->loops.front().first);
            v(block.apex) = top + heightOf((at(block.apex) - last->centre).norm(), perimeterOf(last->radius),
                                           m_repeats[node]);
        }
    }

    /// Whether the wood of a node has one outline, cavities aside.
    bool isOne(std::uint32_t node) const
    {
        const std::vector<SectionLoop>& outline = m_tubes.nodes[node].whole.loops;
        return outline.size() < 2 ||
               std::ranges::count_if(outline, [](const SectionLoop& loop) { return !loop.isCavity(); }) == 1;
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
                m_last[strands[i] - offset] = loop.first + i;
                m_stamp[strands[i] - offset] = m_round;
            }
        }
    }

    /// The rise of v over @p rise, m, where the texture repeats @p repeats times along @p length, m.
    static float heightOf(float rise, float length, float repeats)
    {
        return rise * repeats / std::max(length, 1e-6F);
    }

    float lengthOf(const Loop& loop) const
    {
        float length = 0.0F;
        for (std::uint32_t i = 0; i < loop.count; ++i)
            length += (at(loop.first + (i + 1) % loop.count) - at(loop.first + i)).norm();
        return length;
    }

    /// How far strands run from the slice below to @p slice, m: on average, or from middle to middle if none
    /// is known. Where bundles part, their middles move to the sides.
    float riseOf(const Slice& slice, const Slice& below) const
    {
        float sum = 0.0F;
        int count = 0;
        for (const Loop& loop : slice.loops) {
            const auto strands = m_sections.strands(loop);
            for (std::uint32_t i = 0; i < strands.size(); ++i) {
                if (m_stamp[strands[i]] == m_round) {
                    sum += (at(loop.first + i) - at(m_last[strands[i]])).norm();
                    ++count;
                }
            }
        }
        return count > 0 ? sum / static_cast<float>(count) : (slice.centre - below.centre).norm();
    }

    /// @p node: to which the slice belongs; @p isWhole: whether its first loop goes around all strands.
    void assignSlice(const Slice& slice, const Slice* below, float vBelow, std::uint32_t node, bool isWhole)
    {
        if (below != nullptr && !slice.loops.front().hasStrands && below->loops.front().hasStrands) {
            takeNearest(slice, *below);
            return;
        }
        const float rise = below == nullptr ? 0.0F : riseOf(slice, *below);
        // Parts of a divided trunk, cavities, and profiles that are far from round have as many repeats as
        // suit their length.
        const float repeats = m_repeats[node];
        const float round = perimeterOf(m_skeleton.nodes[node].radius);
        const float length = lengthOf(slice.loops.front());
        const auto hasProfile = [&](std::uint32_t n) { return m_layouts.profileScale(n) > 0.0F; };
        const bool mayBeLong = hasProfile(node) || hasProfile(m_skeleton.nodes[node].parent);
        const bool isRound = isWhole && (!mayBeLong || length < kNearlyRound * round);
        const float own = isRound ? repeats : std::max(1.0F, std::round(repeats * length / round));
        const float height = below == nullptr ? 0.0F : vBelow + heightOf(rise, length, own);
        for (const Loop& loop : slice.loops) {
            for (std::uint32_t i = 0; i < loop.count; ++i)
                v(loop.first + i) = height;
            const bool isFirst = &loop == &slice.loops.front();
            assignLoop(loop, slice.centre, below, rise,
                       isFirst ? own : std::max(1.0F, std::round(repeats * lengthOf(loop) / round)));
        }
    }

    /// The ring of a twig where it leaves thick wood has the coordinates of the bark there, so that this
    /// reaches up to the twig; the twig's own begin above.
    void takeNearest(const Slice& ring, const Slice& below)
    {
        const Loop& loop = ring.loops.front();
        for (std::uint32_t i = 0; i < loop.count; ++i) {
            const VertexIndex nearest = nearestOf(below, at(loop.first + i));
            u(loop.first + i) = u(nearest);
            v(loop.first + i) = v(nearest);
        }
    }

    /// The vertex of @p slice that is nearest to @p place.
    VertexIndex nearestOf(const Slice& slice, const Vec3& place) const
    {
        float least = std::numeric_limits<float>::max();
        VertexIndex result = slice.loops.front().first;
        for (const Loop& loop : slice.loops) {
            for (std::uint32_t i = 0; i < loop.count; ++i) {
                if (const float distance = (at(loop.first + i) - place).squaredNorm(); distance < least) {
                    least = distance;
                    result = loop.first + i;
                }
            }
        }
        return result;
    }

    void assignLoop(const Loop& loop, const Vec3& centre, const Slice* below, float rise, float repeats)
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
            const float phase = below == nullptr ? 0.0F : u(nearestOf(*below, place));
            for (std::uint32_t i = 0; i < loop.count; ++i)
                u(loop.first + i) = phase + repeats * m_arc[i];
            return;
        }
        spanFixed(loop, strands, repeats);
        const auto weightAfter = [&](float even) { return 1.0F - std::exp(-rise / length / even); };
        relax(loop, repeats,
              std::max(weightAfter(kEvenAfter),
                       std::min(weightToBear(loop, repeats), weightAfter(kSoonEvenAfter))));
    }

    /// The share of the loop's length from one vertex to the next known one.
    float shareTo(std::uint32_t from, std::uint32_t to) const
    {
        const float share = m_arc[to] - m_arc[from];
        return share > 0.0F || m_fixed.size() > 1 ? share + (share < 0.0F ? 1.0F : 0.0F) : 1.0F;
    }

    /// Between vertices whose u is known, u rises with the length of the loop; around the whole loop by @p
    /// repeats.
    void spanFixed(const Loop& loop, std::span<const std::uint32_t> strands, float repeats)
    {
        m_rises.clear();
        float sum = 0.0F;
        std::size_t widest = 0;
        float most = -1.0F;
        for (std::size_t f = 0; f < m_fixed.size(); ++f) {
            const std::uint32_t from = m_fixed[f];
            const std::uint32_t to = m_fixed[(f + 1) % m_fixed.size()];
            const float share = shareTo(from, to);
            float rise = m_known[strands[to]] - m_known[strands[from]];
            rise += std::round(repeats * share - rise);
            m_rises.push_back(rise);
            sum += rise;
            if (share > most) {
                most = share;
                widest = f;
            }
        }
        // Strands come and go between known ones: what is amiss lies where there is most room.
        m_rises[widest] += std::round(repeats - sum);
        float start = m_known[strands[m_fixed.front()]];
        for (std::size_t f = 0; f < m_fixed.size(); ++f) {
            const std::uint32_t from = m_fixed[f];
            const std::uint32_t to = m_fixed[(f + 1) % m_fixed.size()];
            const float share = std::max(shareTo(from, to), 1e-9F);
            const std::uint32_t between = (to + loop.count - from - 1) % loop.count + 1;
            for (std::uint32_t j = 0; j < between; ++j) {
                const std::uint32_t i = (from + j) % loop.count;
                const float part = j == 0 ? 0.0F : shareTo(from, i);
                u(loop.first + i) = start + m_rises[f] * part / share;
            }
            start += m_rises[f];
        }
    }

    /// How far u must be drawn toward even spacing so that the bark is nowhere stretched or squeezed too
    /// much.
    float weightToBear(const Loop& loop, float repeats) const
    {
        float weight = 0.0F;
        std::uint32_t end = 0; // Of the stretch of bark that begins at i, counted on around the loop
        const auto arcAt = [&](std::uint32_t i) {
            return m_arc[i % loop.count] + static_cast<float>(i / loop.count);
        };
        const auto uAt = [&](std::uint32_t i) {
            return m_mesh.vertices[loop.first + i % loop.count].uv[0] +
                   repeats * static_cast<float>(i / loop.count);
        };
        for (std::uint32_t i = 0; i < loop.count; ++i) {
            end = std::max(end, i + 1);
            while (arcAt(end) - arcAt(i) < kStretchShare)
                ++end;
            const float density = (uAt(end) - uAt(i)) / (repeats * (arcAt(end) - arcAt(i)));
            if (density < kLeastDensity)
                weight = std::max(weight, (kLeastDensity - density) / (1.0F - density));
            else if (density > kMostDensity)
                weight = std::max(weight, (density - kMostDensity) / (density - 1.0F));
        }
        return weight;
    }

    /// Draws u toward even spacing, so that bark which strands have squeezed together or pulled apart widens
    /// or narrows again further up; the mean turn around the branch stays that of the strands. @p weight: how
    /// far, 0...1.
    void relax(const Loop& loop, float repeats, float weight)
    {
        const std::uint32_t first = m_fixed.front();
        const auto evenAt = [&](std::uint32_t i) {
            return repeats * (m_arc[i] - m_arc[first] + (i < first ? 1.0F : 0.0F));
        };
        double sum = 0.0;
        for (std::uint32_t i = 0; i < loop.count; ++i)
            sum += u(loop.first + i) - evenAt(i);
        const auto turn = static_cast<float>(sum / loop.count);
        for (std::uint32_t i = 0; i < loop.count; ++i)
            u(loop.first + i) += weight * (turn + evenAt(i) - u(loop.first + i));
    }

    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
    const StrandTubes& m_tubes;
    const StrandSections& m_sections;
    float m_scale;
    BranchMesh& m_mesh;
    std::vector<float>& m_repeats;   ///< By node: of the texture around it
    std::vector<float> m_known;      ///< u by strand, where m_stamp is the present round
    std::vector<VertexIndex> m_last; ///< Vertex of the strand that was learned last, likewise
    std::vector<std::uint32_t> m_stamp;
    std::uint32_t m_round = 0;
    std::vector<float> m_arc;
    std::vector<std::uint32_t> m_fixed; ///< Vertices of the loop whose u is known
    std::vector<float> m_rises;         ///< Of u, from each of them to the next
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

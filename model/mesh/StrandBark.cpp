// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandBark.h"

#include "model/base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace espalier {

namespace {

using Slice = StrandSections::Slice;
using Loop = StrandSections::Loop;

constexpr std::size_t kVerticesPerTask = 1 << 14;
/// Of what is uneven in u, 1/e is left after so many perimeters along the branch.
constexpr float kEvenAfter = 0.3F;

/// Assigns u and v, bases first.
class BarkCoordinates {
public:
    BarkCoordinates(const StrandLayouts& layouts, const StrandTubes& tubes, const StrandSections& sections,
                    const TreeParameters& parameters, BranchMesh& mesh)
        : m_layouts(layouts),
          m_skeleton(layouts.skeleton()),
          m_tubes(tubes),
          m_sections(sections),
          m_scale(static_cast<float>(parameters.bark.scale)),
          m_mesh(mesh),
          m_repeats(tubes.nodes.size(), 1.0F)
    {
        std::uint32_t most = 0;
        for (const StrandNode& node : m_skeleton.nodes)
            most = std::max(most, node.strands);
        m_known.resize(most);
        m_last.resize(most);
        m_stamp.assign(most, 0);
    }

    void assign()
    {
        for (std::uint32_t node = 0; node < m_tubes.nodes.size(); ++node) {
            if (m_skeleton.isBase(node))
                assignBase(node);
            else
                assignNode(node);
        }
    }

private:
    /// How often the texture repeats along @p length, m.
    float repeatsOf(float length) const { return std::max(1.0F, std::round(length / m_scale)); }
    static float perimeterOf(float radius) { return 2.0F * std::numbers::pi_v<float> * radius; }

    Vec3 at(VertexIndex vertex) const { return toVec3(m_mesh.vertices[vertex].position); }
    float& u(VertexIndex vertex) { return m_mesh.vertices[vertex].uv[0]; }
    float& v(VertexIndex vertex) { return m_mesh.vertices[vertex].uv[1]; }

    void assignBase(std::uint32_t node)
    {
        const StrandNode& n = m_skeleton.nodes[node];
        const auto above = m_skeleton.childrenOf(node);
        // Without the flare.
        const float share = above.empty() ? 1.0F : m_skeleton.nodes[above.front()].radius / n.radius;
        m_repeats[node] = repeatsOf(share * lengthOf(m_sections.block(node).whole.front().loops.front()));
        forget();
        for (const Slice& slice : m_sections.block(node).whole)
            assignSlice(slice, nullptr, 0.0F, node, true);
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
        const std::vector<SectionLoop>& outline = m_tubes.nodes[node].whole.loops;
        const bool isOne = outline.size() < 2 || std::ranges::count_if(outline, [](const SectionLoop& loop) {
                                                     return !loop.isCavity();
                                                 }) == 1;
        for (const Slice& slice : block.whole) {
            assignSlice(slice, last, top, node, isOne);
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
        // Parts of a divided trunk and cavities have as many repeats as suit their length.
        const float repeats = m_repeats[node];
        const float round = perimeterOf(m_skeleton.nodes[node].radius);
        const float length = lengthOf(slice.loops.front());
        const float own = isWhole ? repeats : std::max(1.0F, std::round(repeats * length / round));
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
        relax(loop, repeats, rise / length);
    }

    /// Between vertices whose u is known, u rises with the length of the loop; around the whole loop by @p
    /// repeats.
    void spanFixed(const Loop& loop, std::span<const std::uint32_t> strands, float repeats)
    {
        const auto shareTo = [&](std::uint32_t from, std::uint32_t to) {
            const float share = m_arc[to] - m_arc[from];
            return share > 0.0F || m_fixed.size() > 1 ? share + (share < 0.0F ? 1.0F : 0.0F) : 1.0F;
        };
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

    /// Draws u toward even spacing, so that bark which strands have squeezed together or pulled apart widens
    /// or narrows again further up; the mean turn around the branch stays that of the strands. @p rise: from
    /// the slice below, in lengths of the loop.
    void relax(const Loop& loop, float repeats, float rise)
    {
        const std::uint32_t first = m_fixed.front();
        const auto evenAt = [&](std::uint32_t i) {
            return repeats * (m_arc[i] - m_arc[first] + (i < first ? 1.0F : 0.0F));
        };
        double sum = 0.0;
        for (std::uint32_t i = 0; i < loop.count; ++i)
            sum += u(loop.first + i) - evenAt(i);
        const auto turn = static_cast<float>(sum / loop.count);
        const float weight = 1.0F - std::exp(-rise / kEvenAfter);
        for (std::uint32_t i = 0; i < loop.count; ++i)
            u(loop.first + i) += weight * (turn + evenAt(i) - u(loop.first + i));
    }

    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
    const StrandTubes& m_tubes;
    const StrandSections& m_sections;
    float m_scale;
    BranchMesh& m_mesh;
    std::vector<float> m_repeats;    ///< By node: of the texture around it
    std::vector<float> m_known;      ///< u by strand, where m_stamp is the present round
    std::vector<VertexIndex> m_last; ///< Vertex of the strand that was learned last, likewise
    std::vector<std::uint32_t> m_stamp;
    std::uint32_t m_round = 0;
    std::vector<float> m_arc;
    std::vector<std::uint32_t> m_fixed; ///< Vertices of the loop whose u is known
    std::vector<float> m_rises;         ///< Of u, from each of them to the next
};

/// Normals by the areas of the triangles around a vertex.
void addNormals(BranchMesh& mesh)
{
    std::vector<Vec3> sums(mesh.vertices.size(), Vec3(Vec3::Zero()));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const VertexIndex a = mesh.indices[i];
        const VertexIndex b = mesh.indices[i + 1];
        const VertexIndex c = mesh.indices[i + 2];
        const Vec3 p = toVec3(mesh.vertices[a].position);
        const Vec3 normal =
            (toVec3(mesh.vertices[b].position) - p).cross(toVec3(mesh.vertices[c].position) - p);
        sums[a] += normal;
        sums[b] += normal;
        sums[c] += normal;
    }
    parallelFor(mesh.vertices.size(), kVerticesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const float length = sums[i].norm();
            mesh.vertices[i].normal = toArray(length > 0.0F ? Vec3(sums[i] / length) : up());
        }
    });
}

/// Tangents along the loops; the bitangent then rises with the branch.
void addTangents(const StrandTubes& tubes, const StrandSections& sections, BranchMesh& mesh)
{
    const auto set = [&](VertexIndex vertex, const Vec3& along) {
        MeshVertex& v = mesh.vertices[vertex];
        const Vec3 normal = toVec3(v.normal);
        Vec3 tangent = along - normal.dot(along) * normal;
        const float length = tangent.norm();
        tangent = length > 1e-9F ? Vec3(tangent / length) : anyPerpendicular(normal);
        v.tangent = {tangent.x(), tangent.y(), tangent.z(), -1.0F};
    };
    const auto setLoops = [&](std::span<const Slice> slices) {
        for (const Slice& slice : slices) {
            for (const Loop& loop : slice.loops) {
                for (std::uint32_t i = 0; i < loop.count; ++i)
                    set(loop.first + i,
                        sections.position(loop.first + (i + 1) % loop.count) -
                            sections.position(loop.first + (i + loop.count - 1) % loop.count));
            }
        }
    };
    parallelFor(tubes.nodes.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const StrandSections::Block& block = sections.block(static_cast<std::uint32_t>(i));
            setLoops(block.slices);
            setLoops(block.whole);
            if (block.hasApex) {
                const Loop& loop = block.top().loops.front();
                set(block.apex, sections.position(loop.first + 1) - sections.position(loop.first));
            }
        }
    });
}

/// Doubles the vertices of triangles across which u starts again.
void splitSeams(BranchMesh& mesh)
{
    std::unordered_map<std::uint64_t, VertexIndex> doubles;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const float u = mesh.vertices[mesh.indices[i]].uv[0];
        for (std::size_t k = 1; k < 3; ++k) {
            const VertexIndex vertex = mesh.indices[i + k];
            const float turns = std::round(u - mesh.vertices[vertex].uv[0]);
            if (turns == 0.0F)
                continue;
            const auto key =
                (std::uint64_t{vertex} << 32U) | static_cast<std::uint32_t>(static_cast<std::int32_t>(turns));
            const auto [found, isNew] =
                doubles.try_emplace(key, static_cast<VertexIndex>(mesh.vertices.size()));
            if (isNew) {
                MeshVertex copy = mesh.vertices[vertex];
                copy.uv[0] += turns;
                mesh.vertices.push_back(copy);
                mesh.origins.push_back(WoodOrigin(mesh.origins[vertex]));
            }
            mesh.indices[i + k] = found->second;
        }
    }
}

} // namespace

void dressStrands(const StrandLayouts& layouts, const StrandTubes& tubes, const StrandSections& sections,
                  const TreeParameters& parameters, BranchMesh& mesh)
{
    addNormals(mesh);
    BarkCoordinates(layouts, tubes, sections, parameters, mesh).assign();
    addTangents(tubes, sections, mesh);
    splitSeams(mesh);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/TubeMesher.h"

#include "model/mesh/RingFrame.h"
#include "model/mesh/Tubes.h"

#include <cassert>
#include <cmath>

namespace espalier {

namespace {

/// From this many sides on a tube is thick enough for a rounder cap and finer bends.
constexpr int kRoundSides = 8;
constexpr int kMostRingsPerSpan = 4;
constexpr float kRingsPerCollar = 3.0F;
/// Most that a tube turns from ring to ring, rad; and a twig.
constexpr float kBend = 0.2F;
constexpr float kTwigBend = 0.45F;
/// Sides that a tube gains with the square root of its thickness.
constexpr double kSidesPerRoot = 2.6;
/// A lateral is thinner than its parent by this much at least, so that their surfaces never coincide.
constexpr float kThinner = 0.9F;
/// A lateral of more than this share of its parent's radius has a root: it begins this many radii below the
/// node, this much thinner, so that its end stays inside the parent even where that bends.
constexpr float kRootedShare = 0.4F;
constexpr float kRootDepth = 0.9F;
constexpr float kRootRadius = 0.45F;
/// Over how many of its radii a branch's direction is told: thick ones grow straight over the kinks of single
/// internodes.
constexpr float kDirectionRadii = 3.0F;
/// The trunk's flare at the ground is gone after so many radii.
constexpr float kFlareRadii = 3.5F;
/// A lateral's collar: how much of its radius it may add, and how far it reaches beyond the parent's axis.
constexpr float kCollar = 0.6F;
constexpr float kCollarParentRadii = 1.0F;
constexpr float kCollarRadii = 2.5F;

} // namespace

TubeMesher::TubeMesher(const Tree& tree, const TreeIndex& index, const Widths& widths,
                       const BranchMeshOptions& options)
    : m_tree(tree),
      m_index(index),
      m_widths(widths),
      m_detail(options.detail),
      m_tipRadius(static_cast<float>(tree.parameters().widths.tipDiameter / 2.0)),
      m_barkScale(static_cast<float>(tree.parameters().bark.scale))
{
}

MeshSize TubeMesher::prepare(InternodeId base)
{
    assert(m_tree.isAlive(base) && beginsTube(m_tree, m_index, base));
    m_internodes.clear();
    m_radii.clear();
    for (InternodeId id = base; id != kNoInternode; id = tubeContinuation(m_index, id)) {
        m_internodes.push_back(id);
        m_radii.push_back(m_widths.radius(m_index, id));
    }

    const InternodeId parent = m_tree.parent(base);
    const bool isTrunk = parent == kNoInternode;
    const float radius = m_radii.front();
    m_parentRadius = isTrunk ? 0.0F : m_widths.radius(m_index, parent);
    if (isTrunk) {
        m_collar = static_cast<float>(m_tree.parameters().widths.flare) * radius;
        m_collarEnd = kFlareRadii * radius;
        m_rooted = false;
    } else {
        const float allowed = kThinner * m_parentRadius - radius;
        m_collar = std::min(kCollar * radius, allowed); // negative: the first ring must be thinner
        m_rooted = sidesFor(radius) >= kRoundSides && radius > kRootedShare * m_parentRadius;
        m_collarEnd = kCollarParentRadii * m_parentRadius + kCollarRadii * radius;
    }
    m_repeats = std::max(1.0F, std::round(2.0F * std::numbers::pi_v<float> * radius / m_barkScale));
    // Branches side by side should not wear the same piece of bark: multiples of the golden ratio, modulo 1.
    m_firstV = static_cast<float>((base * 2654435769U) >> 8U) * 0x1.0p-24F;

    chooseKnots();
    const Vec3 heading = m_index.heading(base);
    Vec3 first = heading;
    if (!isTrunk) {
        // The first control point lies on the parent's line, nearer to the node the more the branch turns
        // back.
        const Vec3 arrival = directionBelow(parent);
        first = 0.45F * (1.0F + arrival.dot(heading)) * arrival + 0.02F * heading;
    }
    findTangents(first);
    chooseRings();

    const Rotation& rotation = m_index.rotation(base);
    const Vec3& tangent = m_knots.front().tangent;
    for (const Vec3& side : {Vec3(rotation * Vec3(Vec3::UnitX())), Vec3(rotation * Vec3(Vec3::UnitZ()))}) {
        m_firstNormal = side - side.dot(tangent) * tangent;
        if (m_firstNormal.squaredNorm() > 0.01F)
            break;
    }
    m_firstNormal.normalize();

    return size();
}

Vec3 TubeMesher::directionBelow(InternodeId id) const
{
    const Vec3& node = m_index.nodePosition(id);
    const float length = kDirectionRadii * m_widths.radius(m_index, id);
    const Vec3 heading = m_index.heading(id);
    Vec3 chord = heading;
    for (float path = 0.0F; id != kNoInternode && (path == 0.0F || path < length); id = m_tree.parent(id)) {
        path += m_tree.length(id);
        chord = node - m_index.basePosition(m_tree, id);
    }
    const float norm = chord.norm();
    return norm > 1e-6F ? Vec3(chord / norm) : heading;
}

MeshSize TubeMesher::size() const
{
    // The base cap is a fan over the first ring; a strip between rings takes two triangles a side, three a
    // coarse side where their number halves.
    const auto firstSides = static_cast<std::uint32_t>(m_knots.front().sides);
    MeshSize size{.vertices = 1, .indices = 3 * (firstSides - 2)};
    if (m_rooted) {
        size.vertices += firstSides + 1;
        size.indices += 3 * 2 * firstSides;
    }
    std::uint32_t below = firstSides;
    for (const Knot& knot : m_knots) {
        const auto sides = static_cast<std::uint32_t>(knot.sides);
        const auto rings = static_cast<std::uint32_t>(knot.rings);
        size.vertices += rings * (sides + 1);
        size.indices += 3 * (rings - 1) * 2 * sides;
        if (&knot != &m_knots.front())
            size.indices += 3 * (below == sides ? 2 * sides : 3 * sides);
        below = sides;
    }
    size.indices += 3 * below;
    return size;
}

void TubeMesher::write(std::span<MeshVertex> vertices, std::span<VertexIndex> indices,
                       VertexIndex firstVertex)
{
    placeRings();
    writeVertices(vertices);
    writeIndices(indices, firstVertex);
}

int TubeMesher::sidesFor(float radius) const
{
    const double thickness = std::sqrt(std::max(1.0F, radius / m_tipRadius));
    const double wanted = (kSideCounts.front() + kSidesPerRoot * (thickness - 1.0)) * m_detail;
    for (const int sides : kSideCounts) {
        if (wanted <= sides + 0.5)
            return sides;
    }
    return kSideCounts.back();
}

void TubeMesher::chooseKnots()
{
    m_knots.clear();
    Knot knot;
    knot.position = m_index.basePosition(m_tree, m_internodes.front());
    knot.radius = m_radii.front();
    knot.sides = sidesFor(knot.radius);
    m_knots.push_back(knot);
    const std::size_t count = m_internodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3& position = m_index.nodePosition(m_internodes[i]);
        const float radius = m_radii[i];
        const float squared = (position - m_knots.back().position).squaredNorm();
        // Strides are powers of two, so that as a branch thickens its rings stay where they are but for every
        // second.
        if (i + 1 < count) {
            std::size_t stride = 1;
            const float length = m_tree.length(m_internodes[i]);
            while (static_cast<float>(stride) * length <= radius)
                stride *= 2;
            if ((i + 1) % stride != 0 || squared < 1e-12F)
                continue;
        }
        knot.position = position;
        knot.radius = radius;
        Knot& below = m_knots.back();
        below.chord = std::max(std::sqrt(squared), 1e-6F);
        below.root = std::sqrt(below.chord);
        knot.path = below.path + below.chord;
        if (const int half = knot.sides / 2;
            half % 2 == 0 && half >= kSideCounts.front() && sidesFor(radius) <= half)
            knot.sides = half;
        m_knots.push_back(knot);
    }
}

void TubeMesher::findTangents(const Vec3& first)
{
    const std::size_t last = m_knots.size() - 1;
    m_knots.front().velocity = m_knots.front().root * first;
    for (std::size_t i = 1; i < last; ++i) {
        const Knot& below = m_knots[i - 1];
        Knot& knot = m_knots[i];
        const Vec3 lower = knot.position - below.position;
        const Vec3 upper = m_knots[i + 1].position - knot.position;
        knot.velocity = lower / below.root - (lower + upper) / (below.root + knot.root) + upper / knot.root;
    }
    m_knots[last].velocity = (m_knots[last].position - m_knots[last - 1].position) / m_knots[last - 1].root;
    for (Knot& knot : m_knots) {
        const float speed = knot.velocity.norm();
        knot.tangent = speed > 1e-9F ? Vec3(knot.velocity / speed) : m_index.heading(m_internodes.front());
    }
}

void TubeMesher::chooseRings()
{
    const auto tolerance = static_cast<float>(1.0 / std::min(m_detail, 1.0));
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        Knot& knot = m_knots[i];
        // |t₁ − t₀| is the angle between them for all angles that matter.
        const float turn = (m_knots[i + 1].tangent - knot.tangent).norm();
        float rings = turn / (tolerance * (knot.sides >= kRoundSides ? kBend : kTwigBend));
        if (knot.sides >= kRoundSides && knot.path < m_collarEnd)
            rings = std::max(rings, kRingsPerCollar * knot.chord / m_collarEnd);
        knot.rings = std::clamp(static_cast<int>(std::ceil(rings)), 1, kMostRingsPerSpan);
    }
    // The end, and where the tube is thick a ring between it and the apex.
    m_knots.back().rings = m_knots.back().sides >= kRoundSides ? 2 : 1;
}

float TubeMesher::widened(float radius, float path) const
{
    if (path >= m_collarEnd)
        return radius;
    const float rest = 1.0F - path / m_collarEnd;
    return radius + m_collar * rest * rest;
}

void TubeMesher::placeRings()
{
    m_rings.clear();
    if (m_rooted) {
        const Knot& node = m_knots.front();
        const float depth = kRootDepth * node.radius;
        m_rings.push_back({node.position - depth * node.tangent, node.tangent, kRootRadius * node.radius,
                           -depth, node.sides});
    }
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        const Knot& a = m_knots[i];
        const Knot& b = m_knots[i + 1];
        m_rings.push_back({a.position, a.tangent, widened(a.radius, a.path), a.path, a.sides});
        for (int j = 1; j < a.rings; ++j) {
            const float t = static_cast<float>(j) / static_cast<float>(a.rings);
            const float s = 1.0F - t;
            const Vec3 rise = b.position - a.position;
            const Vec3 leave = a.root * a.velocity;
            const Vec3 arrive = a.root * b.velocity;
            const Vec3 centre =
                a.position + t * t * (3.0F - 2.0F * t) * rise + t * s * s * leave - t * t * s * arrive;
            const Vec3 velocity =
                6.0F * t * s * rise + s * (s - 2.0F * t) * leave + t * (t - 2.0F * s) * arrive;
            const float speed = velocity.norm();
            const float path = a.path + t * a.chord;
            m_rings.push_back({centre, speed > 1e-9F ? Vec3(velocity / speed) : a.tangent,
                               widened(s * a.radius + t * b.radius, path), path, a.sides});
        }
    }
    const Knot& end = m_knots.back();
    m_rings.push_back({end.position, end.tangent, widened(end.radius, end.path), end.path, end.sides});
}

void TubeMesher::writeVertices(std::span<MeshVertex> vertices) const
{
    const std::size_t count = m_rings.size();
    const float density = m_repeats / (2.0F * std::numbers::pi_v<float>);
    MeshVertex* vertex = vertices.data();
    Vec3 normal = m_firstNormal;
    float v = m_firstV;
    for (std::size_t i = 0; i < count; ++i) {
        const Ring& ring = m_rings[i];
        const Ring& below = m_rings[i > 0 ? i - 1 : 0];
        const Ring& above = m_rings[i + 1 < count ? i + 1 : i];
        if (i > 0) {
            const float rise = ring.path - below.path;
            const float widening = ring.radius - below.radius;
            const float step = std::sqrt(rise * rise + widening * widening);
            v += density * step * 2.0F / (ring.radius + below.radius);
            normal = transported(normal, below.centre, below.tangent, ring.centre, ring.tangent);
        }
        const float slant = (below.radius - above.radius) / (above.path - below.path);
        RingFrame(ring.centre, ring.tangent, normal, ring.radius, slant, v)
            .write(vertex, ring.sides, m_repeats);
        vertex += ring.sides + 1;
    }

    const Ring& end = m_rings.back();
    if (end.sides >= kRoundSides) {
        constexpr float diagonal = std::numbers::sqrt2_v<float> / 2.0F;
        const Vec3 centre = end.centre + diagonal * end.radius * end.tangent;
        v += density * std::numbers::pi_v<float> / 4.0F;
        RingFrame(centre, end.tangent, normal, diagonal * end.radius, 1.0F, v)
            .write(vertex, end.sides, m_repeats);
        vertex += end.sides + 1;
    }
    v += density * std::numbers::pi_v<float> / 4.0F;
    *vertex = {.position = toArray(end.centre + end.radius * end.tangent),
               .normal = toArray(end.tangent),
               .tangent = {normal.x(), normal.y(), normal.z(), 1.0F},
               .uv = {0.5F * m_repeats, v}};
    assert(vertex + 1 == vertices.data() + vertices.size());
}

void TubeMesher::writeIndices(std::span<VertexIndex> indices, VertexIndex firstVertex) const
{
    VertexIndex* index = indices.data();
    const auto triangle = [&index](VertexIndex a, VertexIndex b, VertexIndex c) {
        index[0] = a;
        index[1] = b;
        index[2] = c;
        index += 3;
    };

    auto sides = static_cast<VertexIndex>(m_rings.front().sides);
    for (VertexIndex i = 1; i + 1 < sides; ++i)
        triangle(firstVertex, firstVertex + i + 1, firstVertex + i);

    VertexIndex lower = firstVertex;
    const auto strip = [&](VertexIndex above) {
        const VertexIndex upper = lower + sides + 1;
        if (above == sides) {
            for (VertexIndex i = 0; i < sides; ++i) {
                triangle(lower + i, lower + i + 1, upper + i + 1);
                triangle(lower + i, upper + i + 1, upper + i);
            }
        } else {
            for (VertexIndex i = 0; i < above; ++i) {
                const VertexIndex fine = lower + 2 * i;
                triangle(fine, fine + 1, upper + i);
                triangle(fine + 1, upper + i + 1, upper + i);
                triangle(fine + 1, fine + 2, upper + i + 1);
            }
        }
        lower = upper;
        sides = above;
    };
    for (std::size_t ring = 1; ring < m_rings.size(); ++ring)
        strip(static_cast<VertexIndex>(m_rings[ring].sides));
    if (m_rings.back().sides >= kRoundSides)
        strip(sides);
    const VertexIndex apex = lower + sides + 1;
    for (VertexIndex i = 0; i < sides; ++i)
        triangle(lower + i, lower + i + 1, apex);
    assert(index == indices.data() + indices.size());
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/AxisMesher.h"

#include <cassert>
#include <cmath>
#include <cstring>

namespace espalier {

namespace {

constexpr int kTableCount = (AxisMesher::kMostSides - AxisMesher::kLeastSides) / 2 + 1;
/// From this many sides on a tube is thick enough for a rounder cap and finer bends.
constexpr int kRoundSides = 8;
constexpr int kMostRingsPerSpan = 4;
/// Sides that a tube gains with the square root of its thickness.
constexpr double kSidesPerRoot = 2.6;
/// A child is thinner than its parent by this much at least, so that their surfaces never coincide.
constexpr float kThinner = 0.98F;
/// The trunk's flare at the ground: half as much again, gone after so many radii.
constexpr float kFlare = 0.5F;
constexpr float kFlareRadii = 3.5F;
/// A lateral's collar: how much of its radius it may add, and how far it reaches beyond the parent's axis.
constexpr float kCollar = 0.6F;
constexpr float kCollarParentRadii = 1.0F;
constexpr float kCollarRadii = 2.5F;

/// Cosine and sine around a ring of m sides and the share of the way; entry m repeats entry 0 exactly, so
/// that the seam welds.
struct RingTable {
    std::array<float, AxisMesher::kMostSides + 1> cosine{};
    std::array<float, AxisMesher::kMostSides + 1> sine{};
    std::array<float, AxisMesher::kMostSides + 1> share{};
};

std::array<RingTable, kTableCount> makeRingTables()
{
    std::array<RingTable, kTableCount> tables;
    for (int t = 0; t < kTableCount; ++t) {
        const int sides = AxisMesher::kLeastSides + 2 * t;
        RingTable& table = tables[static_cast<std::size_t>(t)];
        for (int i = 0; i <= sides; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i % sides) / sides;
            const auto entry = static_cast<std::size_t>(i);
            table.cosine[entry] = static_cast<float>(std::cos(angle));
            table.sine[entry] = static_cast<float>(std::sin(angle));
            table.share[entry] = static_cast<float>(i) / static_cast<float>(sides);
        }
    }
    return tables;
}

const RingTable& ringTable(int sides)
{
    static const std::array<RingTable, kTableCount> tables = makeRingTables();
    return tables[static_cast<std::size_t>((sides - AxisMesher::kLeastSides) / 2)];
}

/// Carries @p normal from one point of a curve to the next with as little twist as can be (double reflection,
/// Wang et al. 2008).
Vec3 transported(const Vec3& normal, const Vec3& from, const Vec3& fromTangent, const Vec3& to,
                 const Vec3& toTangent)
{
    const Vec3 chord = to - from;
    const float chordSquared = chord.squaredNorm();
    Vec3 carried = normal;
    Vec3 tangent = fromTangent;
    if (chordSquared > 0.0F) {
        const float scale = 2.0F / chordSquared;
        carried -= scale * chord.dot(normal) * chord;
        tangent -= scale * chord.dot(fromTangent) * chord;
    }
    const Vec3 bisector = toTangent - tangent;
    const float bisectorSquared = bisector.squaredNorm();
    // A reversal has no frame that is nearest; any will do.
    if (bisectorSquared > 1e-12F)
        carried -= 2.0F / bisectorSquared * bisector.dot(carried) * bisector;
    // Rounding must not build up along an axis of thousands of rings.
    carried -= carried.dot(toTangent) * toTangent;
    const float squared = carried.squaredNorm();
    return squared > 1e-8F ? Vec3(carried / std::sqrt(squared)) : anyPerpendicular(toTangent);
}

/// What one ring's vertices have in common: a vertex is base + cosine · C + sine · S, twelve numbers in the
/// order of MeshVertex, but for u.
struct RingFrame {
    std::array<Eigen::Array4f, 3> base;
    std::array<Eigen::Array4f, 3> cosine;
    std::array<Eigen::Array4f, 3> sine;

    /// @p slant: rise of the normal along the axis per unit outward.
    RingFrame(const Vec3& centre, const Vec3& tangent, const Vec3& normal, float radius, float slant, float v)
    {
        const Vec3 binormal = tangent.cross(normal);
        const float outward = 1.0F / std::sqrt(1.0F + slant * slant);
        const Vec3 n = outward * normal;
        const Vec3 b = outward * binormal;
        const Vec3 rise = outward * slant * tangent;
        const Vec3 rn = radius * normal;
        const Vec3 rb = radius * binormal;
        base[0] = {centre.x(), centre.y(), centre.z(), rise.x()};
        base[1] = {rise.y(), rise.z(), 0.0F, 0.0F};
        base[2] = {0.0F, 1.0F, 0.0F, v};
        cosine[0] = {rn.x(), rn.y(), rn.z(), n.x()};
        cosine[1] = {n.y(), n.z(), binormal.x(), binormal.y()};
        cosine[2] = {binormal.z(), 0.0F, 0.0F, 0.0F};
        sine[0] = {rb.x(), rb.y(), rb.z(), b.x()};
        sine[1] = {b.y(), b.z(), -normal.x(), -normal.y()};
        sine[2] = {-normal.z(), 0.0F, 0.0F, 0.0F};
    }

    void write(MeshVertex* vertex, const RingTable& table, int sides, float repeats) const
    {
        static_assert(offsetof(MeshVertex, normal) == 12 && offsetof(MeshVertex, tangent) == 24 &&
                      offsetof(MeshVertex, uv) == 40);
        for (std::size_t i = 0; i <= static_cast<std::size_t>(sides); ++i) {
            const float c = table.cosine[i];
            const float s = table.sine[i];
            std::array<Eigen::Array4f, 3> values;
            for (std::size_t part = 0; part < 3; ++part)
                values[part] = base[part] + c * cosine[part] + s * sine[part];
            values[2].z() = repeats * table.share[i];
            std::memcpy(static_cast<void*>(vertex + i), values.data(), sizeof(MeshVertex));
        }
    }
};

} // namespace

AxisMesher::AxisMesher(const Tree& tree, const TreeIndex& index, const Widths& widths,
                       const BranchMeshOptions& options)
    : m_tree(tree),
      m_index(index),
      m_widths(widths),
      m_detail(options.detail),
      m_tipRadius(static_cast<float>(tree.parameters().widths.tipDiameter / 2.0)),
      m_barkScale(static_cast<float>(tree.parameters().bark.scale))
{
}

MeshSize AxisMesher::prepare(InternodeId axis)
{
    assert(m_index.axis(axis) == axis && m_tree.isAlive(axis));
    m_internodes.clear();
    m_radii.clear();
    for (InternodeId id = axis; id != kNoInternode; id = m_index.mainChild(id)) {
        m_internodes.push_back(id);
        m_radii.push_back(m_widths.radius(m_index, id));
    }

    const InternodeId parent = m_tree.parent(axis);
    const bool isTrunk = parent == kNoInternode;
    const float radius = m_radii.front();
    m_parentRadius = isTrunk ? 0.0F : m_widths.radius(m_index, parent);
    if (isTrunk) {
        m_collar = kFlare * radius;
        m_collarEnd = kFlareRadii * radius;
    } else {
        const float allowed = kThinner * m_parentRadius - radius;
        m_collar = std::min(kCollar * radius, allowed); // negative: the first ring must be thinner
        m_collarEnd = kCollarParentRadii * m_parentRadius + kCollarRadii * radius;
    }
    chooseSides(radius);
    m_repeats = std::max(1.0F, std::round(2.0F * std::numbers::pi_v<float> * radius / m_barkScale));
    // Branches side by side should not wear the same piece of bark.
    m_firstV = static_cast<float>(std::fmod(0.6180339887 * axis, 1.0));

    chooseKnots();
    const Vec3 heading = m_index.heading(axis);
    Vec3 first = heading;
    if (!isTrunk) {
        // The first control point lies on the parent's line, nearer to the node the more the branch turns
        // back.
        const Vec3 parentHeading = m_index.heading(parent);
        first = 0.45F * (1.0F + parentHeading.dot(heading)) * parentHeading + 0.02F * heading;
    }
    findTangents(first);
    chooseRings();

    const Rotation& rotation = m_index.rotation(axis);
    const Vec3& tangent = m_knots.front().tangent;
    for (const Vec3& side : {Vec3(rotation * Vec3(Vec3::UnitX())), Vec3(rotation * Vec3(Vec3::UnitZ()))}) {
        m_firstNormal = side - side.dot(tangent) * tangent;
        if (m_firstNormal.squaredNorm() > 0.01F)
            break;
    }
    m_firstNormal.normalize();

    const auto rings = static_cast<std::uint32_t>(m_ringCount);
    const auto sides = static_cast<std::uint32_t>(m_sides);
    return {rings * (sides + 1) + 1, (rings - 1) * sides * 6 + sides * 3 + (sides - 2) * 3};
}

void AxisMesher::write(std::span<MeshVertex> vertices, std::span<VertexIndex> indices,
                       VertexIndex firstVertex)
{
    placeRings();
    writeVertices(vertices);
    writeIndices(indices, firstVertex);
}

void AxisMesher::chooseSides(float radius)
{
    const double thickness = std::sqrt(std::max(1.0, static_cast<double>(radius) / m_tipRadius));
    const double sides = (kLeastSides + kSidesPerRoot * (thickness - 1.0)) * m_detail;
    m_sides = 2 * std::clamp(static_cast<int>(std::lround(sides / 2.0)), kLeastSides / 2, kMostSides / 2);
}

void AxisMesher::chooseKnots()
{
    m_knots.clear();
    Knot knot;
    knot.position = m_index.basePosition(m_tree, m_internodes.front());
    knot.radius = m_radii.front();
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
            while (static_cast<float>(2 * stride) * length <= radius)
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
        m_knots.push_back(knot);
    }
}

void AxisMesher::findTangents(const Vec3& first)
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

void AxisMesher::chooseRings()
{
    const float bend = (m_sides >= kRoundSides ? 0.2F : 0.45F) / static_cast<float>(std::min(m_detail, 1.0));
    m_ringCount = 1;
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        Knot& knot = m_knots[i];
        // |t₁ − t₀| is the angle between them for all angles that matter.
        const float turn = (m_knots[i + 1].tangent - knot.tangent).norm();
        float rings = turn / bend;
        if (m_sides >= kRoundSides && knot.path < m_collarEnd)
            rings = std::max(rings, 3.0F * knot.chord / m_collarEnd);
        knot.rings = std::clamp(static_cast<int>(std::ceil(rings)), 1, kMostRingsPerSpan);
        m_ringCount += knot.rings;
    }
    if (m_sides >= kRoundSides)
        ++m_ringCount; // of the cap
}

float AxisMesher::widened(float radius, float path) const
{
    if (path >= m_collarEnd)
        return radius;
    const float rest = 1.0F - path / m_collarEnd;
    return radius + m_collar * rest * rest;
}

void AxisMesher::placeRings()
{
    m_rings.clear();
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        const Knot& a = m_knots[i];
        const Knot& b = m_knots[i + 1];
        m_rings.push_back({a.position, a.tangent, widened(a.radius, a.path), a.path});
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
                               widened(s * a.radius + t * b.radius, path), path});
        }
    }
    const Knot& end = m_knots.back();
    m_rings.push_back({end.position, end.tangent, widened(end.radius, end.path), end.path});
}

void AxisMesher::writeVertices(std::span<MeshVertex> vertices) const
{
    const RingTable& table = ringTable(m_sides);
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
            .write(vertex, table, m_sides, m_repeats);
        vertex += m_sides + 1;
    }

    const Ring& end = m_rings.back();
    if (m_sides >= kRoundSides) {
        constexpr float diagonal = std::numbers::sqrt2_v<float> / 2.0F;
        const Vec3 centre = end.centre + diagonal * end.radius * end.tangent;
        v += density * std::numbers::pi_v<float> / 4.0F;
        RingFrame(centre, end.tangent, normal, diagonal * end.radius, 1.0F, v)
            .write(vertex, table, m_sides, m_repeats);
        vertex += m_sides + 1;
    }
    v += density * std::numbers::pi_v<float> / 4.0F;
    *vertex = {.position = toArray(end.centre + end.radius * end.tangent),
               .normal = toArray(end.tangent),
               .tangent = {normal.x(), normal.y(), normal.z(), 1.0F},
               .uv = {0.5F * m_repeats, v}};
    assert(vertex + 1 == vertices.data() + vertices.size());
}

void AxisMesher::writeIndices(std::span<VertexIndex> indices, VertexIndex firstVertex) const
{
    const auto sides = static_cast<VertexIndex>(m_sides);
    const VertexIndex stride = sides + 1;
    VertexIndex* index = indices.data();
    for (VertexIndex i = 1; i + 1 < sides; ++i) {
        *index++ = firstVertex;
        *index++ = firstVertex + i + 1;
        *index++ = firstVertex + i;
    }
    VertexIndex ring = firstVertex;
    for (int r = 1; r < m_ringCount; ++r, ring += stride) {
        for (VertexIndex lower = ring; lower < ring + sides; ++lower) {
            const VertexIndex upper = lower + stride;
            index[0] = lower;
            index[1] = lower + 1;
            index[2] = upper + 1;
            index[3] = lower;
            index[4] = upper + 1;
            index[5] = upper;
            index += 6;
        }
    }
    const VertexIndex apex = ring + stride;
    for (VertexIndex i = 0; i < sides; ++i) {
        *index++ = ring + i;
        *index++ = ring + i + 1;
        *index++ = apex;
    }
    assert(index == indices.data() + indices.size());
}

} // namespace espalier

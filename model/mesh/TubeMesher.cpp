// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/TubeMesher.h"

#include "model/mesh/RingFrame.h"
#include "model/mesh/Tubes.h"

#include <cassert>
#include <cmath>

namespace espalier {

namespace {

constexpr float kMostRingsPerSpan = 4.0F;
constexpr float kRingsPerCollar = 3.0F;
/// The largest turn of a thick tube from ring to ring, rad: shading shows a kink that the outline does not.
constexpr float kBend = 0.2F;
/// The curve between nodes is interpolated, so the mesh may miss it by this many tolerances.
constexpr float kCurveTolerances = 5.0F;
/// The most internodes over which a branch's direction is measured.
constexpr int kDirectionInternodes = 256;
/// A lateral is at least this much thinner than its parent, so that their surfaces never coincide.
constexpr float kThinner = 0.9F;
/// A lateral of more than this share of its parent's radius has a root: it begins this many radii below the
/// node, this much thinner, so that its end stays inside the parent even where the parent bends.
constexpr float kRootedShare = 0.4F;
constexpr float kRootDepth = 0.9F;
constexpr float kRootRadius = 0.45F;
/// The length over which a branch's direction is measured, in its radii: thick branches grow straight over
/// the kinks of single internodes.
constexpr float kDirectionRadii = 3.0F;
/// The trunk's flare ends at this height, in radii.
constexpr float kFlareRadii = 3.5F;
/// A lateral's collar: the share of its radius that it can add, and how far it reaches beyond the parent's
/// axis.
constexpr float kCollar = 0.6F;
constexpr float kCollarParentRadii = 1.0F;
constexpr float kCollarRadii = 2.5F;

} // namespace

namespace {

class TubeWood final : public WoodMesher {
public:
    void joinedChildren(const TreeIndex& index, InternodeId id,
                        std::vector<InternodeId>& children) const override
    {
        children.clear();
        if (const InternodeId next = tubeContinuation(index, id); next != kNoInternode)
            children.push_back(next);
    }
    std::unique_ptr<WoodPieceMesher> pieceMesher(const Tree& tree, const TreeIndex& index,
                                                 const Widths& widths,
                                                 const WoodMeshOptions& options) const override
    {
        return std::make_unique<TubeMesher>(tree, index, widths, options);
    }
};

} // namespace

const WoodMesher& tubeWood()
{
    static const TubeWood wood;
    return wood;
}

TubeMesher::TubeMesher(const Tree& tree, const TreeIndex& index, const Widths& widths,
                       const WoodMeshOptions& options)
    : m_tree(tree),
      m_index(index),
      m_widths(widths),
      m_tolerance(std::max(options.tolerance, WoodMeshOptions::kFinest)),
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
    m_thickest = m_radii;
    for (std::size_t i = m_thickest.size(); i-- > 1;)
        m_thickest[i - 1] = std::max(m_thickest[i - 1], m_thickest[i]);

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
    // Neighbouring branches must not show the same piece of bark: multiples of the golden ratio, modulo 1.
    m_firstV = static_cast<float>((base * 2654435769U) >> 8U) * 0x1.0p-24F;

    chooseKnots();
    const Vec3 heading = m_index.heading(base);
    // The whole foot of a trunk stands on the ground, also if the trunk leans.
    Vec3 first = heading.y() > 0.0F ? up() : heading;
    if (!isTrunk) {
        // The first control point lies on the parent's line, and nearer to the node for a branch that turns
        // back more.
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
    float path = 0.0F;
    for (int i = 0; i < kDirectionInternodes && id != kNoInternode && (i == 0 || path < length); ++i) {
        path += m_tree.length(id);
        chord = node - m_index.basePosition(m_tree, id);
        id = m_tree.parent(id);
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
    writeRingVertices(m_rings, {.normal = m_firstNormal, .repeats = m_repeats, .v = m_firstV}, vertices);
    writeRingIndices(m_rings, indices, firstVertex);
}

int TubeMesher::sidesFor(float radius) const
{
    // The chord of a ring with m sides lies r (1 − cos π/m) deep in the circle.
    const double cosine = 1.0 - m_tolerance / std::max(static_cast<double>(radius), m_tolerance);
    const double wanted = std::numbers::pi / std::acos(cosine);
    for (const int sides : kSideCounts) {
        if (wanted <= sides)
            return sides;
    }
    return kSideCounts.back();
}

/// Number of internodes between two knots at @p place, where internodes are short. A power of two, so that
/// when a branch thickens, every second ring is removed and the others stay.
std::size_t TubeMesher::strideAt(std::size_t place) const
{
    const float radius = m_radii[place];
    const float length = m_tree.length(m_internodes[place]);
    const std::size_t most = std::bit_ceil(m_internodes.size());
    // Also true for NaN and 0.
    if (!(length * static_cast<float>(most) > radius))
        return most;
    return std::bit_ceil(static_cast<std::size_t>(radius / length) + 1);
}

void TubeMesher::chooseKnots()
{
    m_knots.clear();
    Knot knot;
    knot.position = m_index.basePosition(m_tree, m_internodes.front());
    knot.radius = m_radii.front();
    knot.sides = sidesFor(std::max(m_thickest.front(), widened(knot.radius, 0.0F)));
    m_knots.push_back(knot);
    const std::size_t count = m_internodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3& position = m_index.nodePosition(m_internodes[i]);
        const float radius = m_radii[i];
        const float squared = (position - m_knots.back().position).squaredNorm();
        if (i + 1 < count && ((i + 1) % strideAt(i) != 0 || squared < 1e-12F))
            continue;
        knot.position = position;
        knot.radius = radius;
        knot.internode = static_cast<std::uint32_t>(i);
        Knot& below = m_knots.back();
        below.chord = std::max(std::sqrt(squared), 1e-6F);
        below.root = std::sqrt(below.chord);
        knot.path = below.path + below.chord;
        if (const int half = knot.sides / 2;
            half % 2 == 0 && half >= kSideCounts.front() &&
            sidesFor(std::max(m_thickest[i], widened(radius, knot.path))) <= half)
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
    const auto tolerance = kCurveTolerances * static_cast<float>(m_tolerance);
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        Knot& knot = m_knots[i];
        // |t₁ − t₀| is the angle between them for all angles that matter.
        const float turn = (m_knots[i + 1].tangent - knot.tangent).norm();
        // An arc of this length and turn is s·φ/8 high; each of k parts of it is lower by the factor k².
        float rings = std::sqrt(knot.chord * turn / (8.0F * tolerance));
        if (knot.sides >= kRoundSides) {
            rings = std::max(rings, turn / kBend);
            if (knot.path < m_collarEnd)
                rings = std::max(rings, kRingsPerCollar * knot.chord / m_collarEnd);
        }
        knot.rings = static_cast<int>(std::ceil(std::clamp(rings, 1.0F, kMostRingsPerSpan)));
    }
    // The end; where the tube is thick, also a ring between it and the apex.
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
    const WoodOrigin foot{m_internodes.front(), 0.0F};
    if (m_rooted) {
        const Knot& node = m_knots.front();
        const float depth = kRootDepth * node.radius;
        m_rings.push_back({node.position - depth * node.tangent, node.tangent, kRootRadius * node.radius,
                           -depth, node.sides, foot});
    }
    for (std::size_t i = 0; i + 1 < m_knots.size(); ++i) {
        const Knot& a = m_knots[i];
        const Knot& b = m_knots[i + 1];
        const WoodOrigin origin = i == 0 ? foot : WoodOrigin{m_internodes[a.internode], 1.0F};
        // The internodes between the knots share the rings between them evenly.
        const std::size_t first = i == 0 ? 0 : a.internode + 1;
        const auto between = static_cast<float>(b.internode + 1 - first);
        m_rings.push_back({a.position, a.tangent, widened(a.radius, a.path), a.path, a.sides, origin});
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
            const float place = std::floor(t * between);
            m_rings.push_back({centre,
                               speed > 1e-9F ? Vec3(velocity / speed) : a.tangent,
                               widened(s * a.radius + t * b.radius, path),
                               path,
                               a.sides,
                               {m_internodes[first + static_cast<std::size_t>(place)], t * between - place}});
        }
    }
    const Knot& end = m_knots.back();
    m_rings.push_back({end.position,
                       end.tangent,
                       widened(end.radius, end.path),
                       end.path,
                       end.sides,
                       {m_internodes.back(), 1.0F}});
}

void TubeMesher::writeOrigins(std::span<WoodOrigin> origins) const
{
    auto place = origins.begin();
    for (const Ring& ring : m_rings)
        place = std::fill_n(place, ring.sides + 1, ring.origin);
    // The cap belongs to the end.
    std::fill(place, origins.end(), m_rings.back().origin);
}

} // namespace espalier

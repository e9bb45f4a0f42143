// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/RingMesh.h"

#include "model/mesh/RingFrame.h"

#include <cassert>
#include <cmath>

namespace espalier {

namespace {

/// A ring whose centre is in the ground shrinks to this share of its radius at least, so that it stays a
/// ring.
constexpr float kLeastBuried = 0.01F;
/// m; used as divisor instead of smaller lengths.
constexpr float kLeastPath = 1e-9F;

/// The radius of a ring, m. If its centre is in the ground, it is the radius of the part of a round branch
/// that a level cut at the ground would show.
float unburied(const TubeRing& ring)
{
    if (ring.centre.y() >= 0.0F)
        return ring.radius;
    const float depth = std::min(1.0F, -ring.centre.y() / ring.radius);
    return ring.radius * std::max(kLeastBuried, std::sqrt(1.0F - depth * depth));
}

/// Writes a ring's vertices, none of them below the ground, and returns the place behind them.
MeshVertex* writeRing(MeshVertex* vertex, const TubeRing& ring, const RingFrame& frame, float repeats)
{
    frame.write(vertex, ring.sides, repeats);
    MeshVertex* const end = vertex + ring.sides + 1;
    // A ring's height is at most twice its radius, and a cap's ring lies that much farther along.
    if (ring.centre.y() < 2.0F * ring.radius) {
        for (MeshVertex* place = vertex; place != end; ++place)
            place->position[1] = std::max(place->position[1], 0.0F);
    }
    return end;
}

} // namespace

void writeRingVertices(std::span<const TubeRing> rings, const RingTexture& start,
                       std::span<MeshVertex> vertices)
{
    const std::size_t count = rings.size();
    const float density = start.repeats / (2.0F * std::numbers::pi_v<float>);
    MeshVertex* vertex = vertices.data();
    Vec3 normal = start.normal;
    float v = start.v;
    for (std::size_t i = 0; i < count; ++i) {
        const TubeRing& ring = rings[i];
        const TubeRing& below = rings[i > 0 ? i - 1 : 0];
        const TubeRing& above = rings[i + 1 < count ? i + 1 : i];
        if (i > 0) {
            const float rise = ring.path - below.path;
            const float widening = ring.radius - below.radius;
            const float step = std::sqrt(rise * rise + widening * widening);
            v += density * step * 2.0F / std::max(ring.radius + below.radius, kLeastPath);
            normal = transported(normal, below.centre, below.tangent, ring.centre, ring.tangent);
        }
        const float slant = (below.radius - above.radius) / std::max(above.path - below.path, kLeastPath);
        vertex =
            writeRing(vertex, ring, RingFrame(ring.centre, ring.tangent, normal, unburied(ring), slant, v),
                      start.repeats);
    }

    const TubeRing& end = rings.back();
    if (end.sides >= kRoundSides) {
        constexpr float diagonal = std::numbers::sqrt2_v<float> / 2.0F;
        const Vec3 centre = end.centre + diagonal * end.radius * end.tangent;
        v += density * std::numbers::pi_v<float> / 4.0F;
        vertex =
            writeRing(vertex, end, RingFrame(centre, end.tangent, normal, diagonal * unburied(end), 1.0F, v),
                      start.repeats);
    }
    v += density * std::numbers::pi_v<float> / 4.0F;
    Vec3 apex = end.centre + end.radius * end.tangent;
    apex.y() = std::max(apex.y(), 0.0F);
    *vertex = {.position = toArray(apex),
               .normal = toArray(end.tangent),
               .tangent = {normal.x(), normal.y(), normal.z(), 1.0F},
               .uv = {0.5F * start.repeats, v}};
    assert(vertex + 1 == vertices.data() + vertices.size());
}

void writeRingIndices(std::span<const TubeRing> rings, std::span<VertexIndex> indices,
                      VertexIndex firstVertex)
{
    VertexIndex* index = indices.data();
    const auto triangle = [&index](VertexIndex a, VertexIndex b, VertexIndex c) {
        index[0] = a;
        index[1] = b;
        index[2] = c;
        index += 3;
    };

    auto sides = static_cast<VertexIndex>(rings.front().sides);
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
    for (std::size_t ring = 1; ring < rings.size(); ++ring)
        strip(static_cast<VertexIndex>(rings[ring].sides));
    if (rings.back().sides >= kRoundSides)
        strip(sides);
    const VertexIndex apex = lower + sides + 1;
    for (VertexIndex i = 0; i < sides; ++i)
        triangle(lower + i, lower + i + 1, apex);
    assert(index == indices.data() + indices.size());
}

} // namespace espalier

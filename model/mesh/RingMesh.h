// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/WoodMesher.h"

namespace espalier {

/// A tube with at least this many sides is thick enough for a rounder cap and finer bends.
inline constexpr int kRoundSides = 8;

/// A ring of a tube's vertices.
struct TubeRing {
    Vec3 centre = Vec3::Zero();
    Vec3 tangent = Vec3::UnitY();
    float radius = 0.0F; ///< m
    float path = 0.0F;   ///< Length of the tube below the ring, m
    int sides = 4;       ///< One of kSideCounts
    WoodOrigin origin;
};

/// Orientation and texture of the first ring.
struct RingTexture {
    Vec3 normal = Vec3::UnitX(); ///< Toward its first vertex
    float repeats = 1.0F;        ///< Repeats of the texture around the tube
    float v = 0.0F;
};

/// Writes the vertices of @p rings, sides + 1 of each from the base up; then a ring of the round cap if the
/// last ring has kRoundSides or more; then the apex. Vertices that would lie below the ground, y = 0, lie on
/// it.
void writeRingVertices(std::span<const TubeRing> rings, const RingTexture& start,
                       std::span<MeshVertex> vertices);

/// Writes the triangles between those vertices: the base cap, a strip between each two rings, of which the
/// upper has as many sides as the lower or half as many, and the apex; @p firstVertex is added.
void writeRingIndices(std::span<const TubeRing> rings, std::span<VertexIndex> indices,
                      VertexIndex firstVertex);

} // namespace espalier

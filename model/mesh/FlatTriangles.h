// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

#include <array>
#include <span>
#include <vector>

namespace espalier {

/// A vertex that was moved, with its position before.
struct RaisedVertex {
    VertexIndex vertex;
    std::array<float, 3> before; ///< m
};

/// Gives triangles without area some, by moving one of their vertices by some hundred-thousandths of the
/// mesh's size, never below the ground. Such triangles come about where vertices of different strands meet by
/// chance.
/// Returns the moved vertices, ascending. The same on one thread and many.
std::vector<RaisedVertex> raiseFlatTriangles(std::span<const VertexIndex> indices,
                                             std::span<MeshVertex> vertices);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

#include <span>

namespace espalier {

/// Gives triangles without area some, by moving one of their vertices by some hundred-thousandths of the
/// mesh's size, never below the ground. Such triangles come about where vertices of different strands meet by
/// chance.
void raiseFlatTriangles(std::span<const VertexIndex> indices, std::span<MeshVertex> vertices);

} // namespace espalier

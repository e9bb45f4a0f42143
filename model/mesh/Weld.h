// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

#include <span>
#include <vector>

namespace espalier {

/// For each vertex the first one at exactly the same place: texture coordinates double vertices of a closed
/// surface.
std::vector<VertexIndex> firstAtSamePlace(std::span<const MeshVertex> vertices);

} // namespace espalier

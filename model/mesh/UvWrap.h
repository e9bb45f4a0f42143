// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

namespace espalier {

/// Greatest v of wrapped texture coordinates, in repeats of the texture, for triangles that are at most twice
/// as high. Half floats have steps of 1/128 there.
inline constexpr float kGreatestV = 8.0F;

/// Returns the mesh with a whole number subtracted from v of each triangle, so that v stays within
/// -kGreatestV...kGreatestV; a triangle that is too high for that is centred on 0. A repeating texture looks
/// the same, and half floats keep the coordinates: without this, v reaches a hundred and more on a long axis.
///
/// Neighbouring triangles share the number where they can, so few vertices are doubled: those between two
/// triangles with different numbers. Vertices are in the order in which triangles first use them; unused
/// vertices are left out.
TriangleMesh withSmallV(const TriangleMesh& mesh);

} // namespace espalier

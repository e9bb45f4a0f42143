// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

namespace espalier {

/// Greatest v of wrapped texture coordinates, in repeats of the texture, for triangles that are not higher
/// than twice as much. Half floats have steps of 1/128 there.
inline constexpr float kGreatestV = 8.0F;

/// Returns the mesh with a whole number subtracted from v of each triangle, so that v stays within
/// -kGreatestV...kGreatestV; a triangle that is too high for that is centred on 0. A texture that repeats
/// looks the same, and half floats keep the coordinates: on a long axis v would rise to a hundred and more.
///
/// The number stays the same from triangle to triangle while it can, so few vertices are doubled: those
/// between two triangles of different numbers. Vertices are in the order in which triangles first name them;
/// one that no triangle names is left out.
TriangleMesh withSmallV(const TriangleMesh& mesh);

} // namespace espalier

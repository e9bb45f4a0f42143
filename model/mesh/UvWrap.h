// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

namespace espalier {

/// v of wrapped texture coordinates begins within half of this around 0, in repeats of the texture.
inline constexpr float kWrapPeriod = 4.0F;

/// Returns the mesh with a whole number subtracted from v of each triangle, so that its least v is at least
/// -kWrapPeriod / 2 and less than kWrapPeriod / 2. A texture that repeats looks the same, and half floats
/// keep the coordinates: on a long axis v would rise to a hundred and more. Vertices are in the order in
/// which triangles first name them; one whose triangles get different numbers is doubled, and one that no
/// triangle names is left out.
TriangleMesh withSmallV(const TriangleMesh& mesh);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Grid.h"

namespace espalier {

/// Chordal axes of a region: thins it to lines one node wide by parallel erosion (Guo & Hall 1989, two
/// subiterations; TreeSketch §3.2 uses the related Hall 1989). Keeps the number of components (8-connected)
/// and of holes (4-connected). Nodes beyond the grid count as outside; nodes in @p kept, which has the same
/// size, are never deleted.
Mask thinned(const Mask& mask, const Mask& kept);
Mask thinned(const Mask& mask);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/BranchMesh.h"
#include "model/mesh/StrandSections.h"

namespace espalier {

/// Sets the texture coordinates of the vertices of @p mesh.
///
/// A vertex keeps the u of its strand from one section to the next, so the bark turns with the strands and
/// has no seam at forks; vertices of strands that come to the surface get a u between those of their
/// neighbours. The texture repeats a whole number of times around each bundle.
void barkStrands(const StrandLayouts& layouts, const StrandTubes& tubes, const StrandSections& sections,
                 const TreeParameters& parameters, BranchMesh& mesh);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/BranchMesh.h"
#include "model/strands/StrandLayouts.h"

namespace espalier {

/// One closed surface around all strands of a tree (Strands 2024 §5.5), for each of its roots.
///
/// Between two nodes each bundle has cross-sections; the outline of a section is a loop of strands, and loops
/// of successive sections are joined strand by strand. Where bundles divide or meet, the region between the
/// outline below and those above is triangulated in the plane of the section (PlanarPatch). So each edge has
/// two triangles, whatever the shape is. Bundles of few strands get rings. Tips and bases are closed.
///
/// u follows the strands around a bundle, v its length, so the bark turns with a twist and flows through
/// forks. Vertices are doubled only where u starts again.
///
/// The result is the same on one thread and many.
BranchMesh meshStrands(const StrandLayouts& layouts, const TreeParameters& parameters,
                       const WoodMeshOptions& options = {});

} // namespace espalier

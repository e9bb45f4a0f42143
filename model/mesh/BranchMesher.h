// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/BranchMesh.h"

namespace espalier {

/// Meshes every piece into which @p mesher divides the tree, in parallel and with the same result on one
/// thread or many.
BranchMesh meshBranches(const Tree& tree, const TreeIndex& index, const Widths& widths,
                        const WoodMeshOptions& options = {}, const WoodMesher& mesher = tubeWood());

} // namespace espalier

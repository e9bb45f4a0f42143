// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/BranchMesh.h"

namespace espalier {

/// Meshes the wood of a tree as its parameters say (WoodParameters::mesher): as tubes, or as strands.
BranchMesh meshWood(const Tree& tree, const TreeIndex& index, const Widths& widths,
                    const WoodMeshOptions& options = {});

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"
#include "model/mesh/WoodLines.h"
#include "model/strands/StrandFibres.h"

namespace espalier {

/// What can be seen of the strands of a tree; it takes too long for a frame, so a worker makes it.
struct StrandWood {
    /// Their surface, and where the wood lies for the leaves. Both are empty if the tree's wood is tubes.
    TriangleMesh mesh;
    StrandLines lines;
    std::vector<FibreVertex> fibres; ///< Empty if they were not asked for
    bool hasFibres = false;          ///< Whether they were
};

/// Makes what is shown of @p tree.
StrandWood strandWood(const Tree& tree, const TreeIndex& index, bool withFibres);

} // namespace espalier

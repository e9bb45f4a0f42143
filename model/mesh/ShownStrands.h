// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/WorkProgress.h"
#include "model/mesh/StrandMesher.h"
#include "model/mesh/WoodLines.h"
#include "model/strands/StrandFibres.h"

namespace espalier {

/// What can be seen of the strands of a tree; it takes too long for a frame, so a worker makes it.
struct ShownStrands {
    /// The strands with their surface; null if the tree's wood is tubes. The next ones can take over what has
    /// not changed.
    std::shared_ptr<const StrandWood> wood;
    StrandLines lines;               ///< Where the wood lies for the leaves; empty if it is tubes
    std::vector<FibreVertex> fibres; ///< Empty if they were not asked for
    bool hasFibres = false;          ///< Whether they were

    bool hasMesh() const { return wood != nullptr; }
    const TriangleMesh& mesh() const { return *wood->mesh; }
};

/// The lines of @p strands, or null if there are none.
std::shared_ptr<const StrandLines> linesOf(const std::shared_ptr<const ShownStrands>& strands);

/// Makes what is shown of @p tree. @p last, which can be null, are strands made before, of this tree or of
/// another. Null if @p progress was cancelled.
std::shared_ptr<const ShownStrands> makeShownStrands(const Tree& tree, bool withFibres,
                                                     const StrandWood* last, WorkProgress& progress);

} // namespace espalier

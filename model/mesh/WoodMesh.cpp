// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/WoodMesh.h"

#include "model/mesh/BranchMesher.h"
#include "model/mesh/StrandMesher.h"

namespace espalier {

BranchMesh meshWood(const Tree& tree, const TreeIndex& index, const Widths& widths,
                    const WoodMeshOptions& options)
{
    if (tree.parameters().wood.mesher == WoodMesherKind::Tubes)
        return meshBranches(tree, index, widths, options);
    return meshStrands(StrandLayouts(tree, index, widths), tree.parameters(), options);
}

} // namespace espalier

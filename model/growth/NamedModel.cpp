// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/NamedModel.h"

#include "model/growth/VigourStep.h"

namespace espalier {

TreeDelta NamedModel::growFreely(const Tree& tree, const TreeIndex& treeIndex,
                                 const GrowthStepOptions& options, GrowthWorkspace& workspace) const
{
    if (tree.parameters().growth.model == GrowthModelKind::Vigour)
        return vigourStep(tree, treeIndex, space(), options, workspace);
    return autonomousStep(tree, treeIndex, index(), options, workspace);
}

TreeDelta NamedModel::growToward(const Tree& tree, const TreeIndex& treeIndex, MarkerSet& markers,
                                 const GrowthStepOptions& options, GrowthWorkspace& workspace) const
{
    if (tree.parameters().growth.model == GrowthModelKind::Vigour)
        return vigourStepToward(tree, treeIndex, space(), markers, options, workspace);
    return growthStep(tree, treeIndex, index(), markers, options, workspace);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/TreeCounts.h"

#include "model/mesh/LeafPlacer.h"

#include <bit>

namespace espalier {

TreeCounts countTree(const Tree& tree, const TreeIndex& index)
{
    const LeafRule leaves(tree, index);
    TreeCounts counts{.steps = tree.step()};
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        ++counts.internodes;
        counts.buds += static_cast<std::uint64_t>(std::popcount(tree.buds(id)));
        if (tree.isRoot(id) || !tree.continuesAxis(id))
            ++counts.axes;
        if (leaves.bears(id))
            counts.leaves += leaves.leavesPerInternode();
    }
    counts.leavesPlaced = placedLeafCount(tree);
    counts.leaves += counts.leavesPlaced;
    return counts;
}

Box3 treeBounds(const Tree& tree, const TreeIndex& index)
{
    Box3 bounds{Vec3(Vec3::Zero())};
    for (const InternodeId root : index.roots()) {
        if (tree.isAlive(root))
            bounds.extend(index.basePosition(tree, root));
    }
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            bounds.extend(index.nodePosition(id));
    }
    extendByPlacedLeaves(bounds, tree, index);
    return bounds;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <vector>

namespace espalier {

/// The wood of a tree is meshed in tubes. At a node a tube continues in the terminal shoot, as an axis does;
/// but if there is none, or if a lateral carries more than twice as many tips, it continues in that lateral,
/// since that is now the main branch. Returns the living internode in which the tube of @p id continues, or
/// kNoInternode. The result is a function of the tree as it is, not of its history.
inline InternodeId tubeContinuation(const TreeIndex& index, InternodeId id)
{
    InternodeId best = index.firstChild(id);
    if (best == kNoInternode || index.nextSibling(best) == kNoInternode)
        return best;
    const InternodeId main = index.mainChild(id);
    std::uint32_t bestTips = 0;
    for (InternodeId child = best; child != kNoInternode; child = index.nextSibling(child)) {
        const std::uint32_t tips = index.tipCount(child) * (child == main ? 2 : 1);
        // At equal numbers of tips the terminal shoot comes first, then the older lateral.
        if (tips > bestTips || (tips == bestTips && child == main)) {
            best = child;
            bestTips = tips;
        }
    }
    return best;
}

/// Whether a living internode is the first of a tube.
inline bool beginsTube(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    const InternodeId parent = tree.parent(id);
    return parent == kNoInternode || tubeContinuation(index, parent) != id;
}

/// The first internodes of all tubes of a tree, ascending.
inline std::vector<InternodeId> tubesOf(const Tree& tree, const TreeIndex& index)
{
    // beginsTube() would visit all children of a node for each of them.
    std::vector<bool> continues(tree.size(), false);
    std::vector<InternodeId> tubes;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        if (const InternodeId next = tubeContinuation(index, id); next != kNoInternode)
            continues[next] = true;
        if (!continues[id])
            tubes.push_back(id);
    }
    return tubes;
}

} // namespace espalier

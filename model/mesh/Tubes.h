// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <vector>

namespace espalier {

/// The wood of a tree is meshed in tubes. A tube goes on through a node's terminal shoot, as an axis does;
/// but where that is missing, or where a lateral carries more than twice as many tips, the lateral is what
/// the branch has become, and the bark follows it. Returns the living internode in which the tube of @p id
/// goes on, or kNoInternode. A function of the tree as it is, not of how it came about.
inline InternodeId tubeContinuation(const TreeIndex& index, InternodeId id)
{
    InternodeId best = index.firstChild(id);
    if (best == kNoInternode || index.nextSibling(best) == kNoInternode)
        return best;
    const InternodeId main = index.mainChild(id);
    std::uint32_t bestTips = 0;
    for (InternodeId child = best; child != kNoInternode; child = index.nextSibling(child)) {
        const std::uint32_t tips = index.tipCount(child) * (child == main ? 2 : 1);
        // A tie is the terminal shoot's, then the elder's.
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
    std::vector<InternodeId> tubes;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id) && beginsTube(tree, index, id))
            tubes.push_back(id);
    }
    return tubes;
}

} // namespace espalier

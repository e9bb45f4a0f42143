// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Pruning.h"

#include <algorithm>

namespace espalier {

InternodeId cutBelow(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    if (!tree.isAlive(id) || tree.isRoot(id))
        return kNoInternode;
    for (;;) {
        const InternodeId parent = tree.parent(id);
        const bool branches = index.nextSibling(index.firstChild(parent)) != kNoInternode;
        if (branches || tree.isRoot(parent) || tree.widthConstraint(parent) > 0.0F)
            return id;
        id = parent;
    }
}

std::vector<InternodeId> falling(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> cuts)
{
    std::vector<InternodeId> fallen;
    for (const InternodeId cut : cuts) {
        if (tree.isAlive(cut) && !tree.isRoot(cut))
            fallen.push_back(cut);
    }
    std::ranges::sort(fallen);
    // The subtree of a cut already contains the cuts above it.
    std::vector<InternodeId> all;
    std::vector<InternodeId> branch;
    for (const InternodeId cut : fallen) {
        branch.push_back(cut);
        while (!branch.empty()) {
            const InternodeId id = branch.back();
            branch.pop_back();
            all.push_back(id);
            for (InternodeId child = index.firstChild(id); child != kNoInternode;
                 child = index.nextSibling(child))
                branch.push_back(child);
        }
    }
    std::ranges::sort(all);
    const auto repeated = std::ranges::unique(all);
    all.erase(repeated.begin(), repeated.end());
    return all;
}

TreeDelta prune(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> cuts)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.died = falling(tree, index, cuts);
    return delta;
}

} // namespace espalier

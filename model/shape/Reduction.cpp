// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Reduction.h"

#include <algorithm>
#include <map>
#include <vector>

namespace espalier {

TreeDelta reduceBranch(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    TreeDelta delta = deltaStartingAt(tree);
    if (!tree.isAlive(id))
        return delta;
    std::vector<InternodeId> branch{id};
    for (std::size_t next = 0; next < branch.size(); ++next) {
        for (InternodeId child = index.firstChild(branch[next]); child != kNoInternode;
             child = index.nextSibling(child))
            branch.push_back(child);
    }
    branch.erase(branch.begin());
    if (branch.empty())
        return delta;
    const auto birthOf = [&tree](InternodeId one) { return tree.birth(one); };
    const Step youngest = birthOf(*std::ranges::max_element(branch, {}, birthOf));
    // No internode is younger than what it carries, so this takes whole ends.
    std::erase_if(branch, [&](InternodeId one) { return birthOf(one) != youngest; });
    std::ranges::sort(branch);
    delta.died = branch;
    std::map<InternodeId, BudStates> buds;
    for (const InternodeId one : branch) {
        const InternodeId parent = tree.parent(one);
        if (std::ranges::binary_search(branch, parent))
            continue;
        const auto [entry, isNew] = buds.try_emplace(parent, tree.budStates(parent));
        entry->second.set(tree.columns().slot[one], BudState::Active);
    }
    for (const auto& [parent, after] : buds)
        delta.internodes.buds.push_back({parent, tree.budStates(parent), after});
    return delta;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/ClearWood.h"

#include "model/shape/Pruning.h"

#include <algorithm>

namespace espalier {

namespace {

bool livesIn(const Tree& tree, InternodeId id)
{
    return id < tree.size() && tree.isAlive(id);
}

/// Calls @p visit(internode, length below it, m) for each internode of the axis of @p id, from its base on.
template <class Visit>
void forEachOnAxis(const Tree& tree, const TreeIndex& index, InternodeId id, Visit&& visit)
{
    float below = 0.0F;
    for (InternodeId on = index.axis(id); on != kNoInternode; on = index.mainChild(on)) {
        visit(on, below);
        below += tree.length(on);
    }
}

/// @p states with resting lateral buds, or with active ones.
BudStates withLaterals(BudStates states, bool rest)
{
    const BudMask laterals = static_cast<BudMask>(states.living & ~kTerminalBud);
    states.other = static_cast<BudMask>(rest ? states.other | laterals : states.other & ~laterals);
    return states;
}

} // namespace

float lengthBelow(const Tree& tree, const TreeIndex& index, InternodeId id, float along)
{
    float length = 0.0F;
    forEachOnAxis(tree, index, id, [&](InternodeId on, float below) {
        if (on == id)
            length = below + along * tree.length(id);
    });
    return length;
}

std::vector<InternodeId> shootsBelow(const Tree& tree, const TreeIndex& index, InternodeId id, float length)
{
    std::vector<InternodeId> shoots;
    if (!livesIn(tree, id))
        return shoots;
    forEachOnAxis(tree, index, id, [&](InternodeId on, float below) {
        for (InternodeId child = index.firstChild(on); child != kNoInternode;
             child = index.nextSibling(child)) {
            if (child != index.mainChild(on) &&
                below + tree.columns().along[child] * tree.length(on) < length)
                shoots.push_back(child);
        }
    });
    std::ranges::sort(shoots);
    return shoots;
}

TreeDelta keepClear(const Tree& tree, const TreeIndex& index, InternodeId id, float length)
{
    TreeDelta delta = deltaStartingAt(tree);
    if (!livesIn(tree, id))
        return delta;
    length = std::clamp(length, 0.0F, kGreatestClearLength);
    const InternodeId axis = index.axis(id);
    const float before = tree.clearLength(axis);
    if (before != length)
        delta.sparse.clearLength.push_back({axis, tree.content().sparse.clearLength.at(axis),
                                            length > 0.0F ? std::optional(length) : std::nullopt});
    delta.died = falling(tree, index, shootsBelow(tree, index, axis, length));
    std::vector<float> lengths(tree.size(), -1.0F); // Below each internode of the axis
    forEachOnAxis(tree, index, axis, [&](InternodeId on, float below) {
        lengths[on] = below;
        const float node = below + tree.length(on);
        if (node >= length && node >= before)
            return;
        const BudStates states = tree.budStates(on);
        if (const BudStates after = withLaterals(states, node < length); after != states)
            delta.internodes.buds.push_back({on, states, after});
    });
    const LeafColumns& leaves = tree.placedLeaves();
    for (LeafId leaf = 0; leaf < leaves.size(); ++leaf) {
        const InternodeId on = leaves.internode[leaf];
        if (leaves.death[leaf] == kNever && lengths[on] >= 0.0F &&
            lengths[on] + leaves.along[leaf] * tree.length(on) < length)
            delta.leaves.death.push_back({leaf, kNever, delta.stepAfter});
    }
    return delta;
}

} // namespace espalier

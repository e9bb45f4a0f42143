// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Twist.h"

#include <algorithm>

namespace espalier {

std::vector<InternodeId> twistedInternodes(const Tree& tree, const TreeIndex& index, InternodeId id,
                                           TwistScope scope)
{
    std::vector<InternodeId> reached;
    if (id >= tree.size() || !tree.isAlive(id))
        return reached;
    if (scope == TwistScope::Branch) {
        for (InternodeId on = id; on != kNoInternode; on = index.mainChild(on))
            reached.push_back(on);
        return reached;
    }
    std::vector<InternodeId> open{id};
    while (!open.empty()) {
        const InternodeId on = open.back();
        open.pop_back();
        reached.push_back(on);
        for (InternodeId child = index.firstChild(on); child != kNoInternode;
             child = index.nextSibling(child))
            open.push_back(child);
    }
    std::ranges::sort(reached);
    return reached;
}

TreeDelta twist(const Tree& tree, const TreeIndex& index, InternodeId id, TwistScope scope, double angle)
{
    TreeDelta delta = deltaStartingAt(tree);
    std::optional<float> after;
    if (angle != 0.0)
        after = static_cast<float>(std::clamp(angle, -kMostTwist, kMostTwist));
    for (const InternodeId reached : twistedInternodes(tree, index, id, scope)) {
        if (const auto before = tree.content().sparse.twist.at(reached); before != after)
            delta.sparse.twist.push_back({reached, before, after});
    }
    return delta;
}

} // namespace espalier

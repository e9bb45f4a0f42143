// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchMove.h"

#include "model/sketch/BranchCopy.h"
#include "model/sketch/SketchText.h"

namespace espalier {

Result<TreeDelta> moved(const Tree& tree, const TreeIndex& index, const BranchMove& move)
{
    const auto refused = [](const QString& why) { return Error{Error::Kind::Input, why}; };
    for (const InternodeId id : {move.branch, move.place.internode}) {
        if (!tree.isAlive(id))
            return refused(SketchText::tr("internode %1 is not alive").arg(id));
    }
    const InternodeId first = index.axis(move.branch);
    if (tree.isRoot(first))
        return refused(SketchText::tr("a trunk cannot be moved"));
    for (InternodeId id = move.place.internode; id != kNoInternode; id = tree.parent(id)) {
        if (id == first)
            return refused(SketchText::tr("a branch cannot stand on itself"));
    }
    if (!(move.scale >= BranchMove::kLeastScale && move.scale <= BranchMove::kMostScale))
        return refused(SketchText::tr("a branch can be made %1 to %2 times as large")
                           .arg(BranchMove::kLeastScale)
                           .arg(BranchMove::kMostScale));
    const InternodeColumns& c = tree.columns();
    if (move.place == BranchPlace{c.parent[first], c.along[first]} && move.rotation == c.rotation[first] &&
        move.scale == 1.0)
        return deltaStartingAt(tree);
    BranchCopies copies(tree, index);
    copies.add(first, {.parent = move.place.internode,
                       .along = move.place.along,
                       .rotation = move.rotation,
                       .scale = move.scale});
    copies.remove(first);
    return copies.finish();
}

} // namespace espalier

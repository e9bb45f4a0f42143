// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/Prune.h"

#include "commands/DeltaCommand.h"
#include "model/shape/Pruning.h"

#include <QCoreApplication>

namespace espalier {

void pruneBranches(TreeDocument& document, std::span<const InternodeId> cuts)
{
    TreeDelta delta = prune(document.tree(), document.index(), cuts);
    if (delta.isEmpty())
        return;
    const Journal deltas{std::make_shared<TreeDelta>(std::move(delta))};
    document.apply(deltas.front());
    document.undoStack().push(
        new DeltaCommand(document, QCoreApplication::translate("Commands", "Prune"), deltas));
}

} // namespace espalier

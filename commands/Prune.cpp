// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/Prune.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/PruneOperation.h"
#include "model/shape/Pruning.h"

#include <QCoreApplication>

namespace espalier {

void pruneBranches(TreeDocument& document, std::span<const InternodeId> cuts)
{
    Edit edit(document);
    PruneOperation operation;
    for (const InternodeId cut : cuts) {
        if (cut != 0 && cut < document.tree().size() && document.tree().isAlive(cut))
            operation.internodes.push_back(InternodeReference::to(document, cut));
    }
    edit.apply(prune(document.tree(), document.index(), cuts));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Prune"), [&] { return operation; });
}

} // namespace espalier

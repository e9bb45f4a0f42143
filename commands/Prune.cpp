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
    const auto count = static_cast<int>(operation.internodes.size());
    commitRecorded(edit,
                   count > 1 ? QCoreApplication::translate("Commands", "Prune, %n branches", nullptr, count)
                             : QCoreApplication::translate("Commands", "Prune"),
                   [&] { return operation; });
}

} // namespace espalier

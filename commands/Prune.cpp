// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/Prune.h"

#include "model/document/Edit.h"
#include "model/shape/Pruning.h"

#include <QCoreApplication>

namespace espalier {

void pruneBranches(TreeDocument& document, std::span<const InternodeId> cuts)
{
    Edit edit(document);
    edit.apply(prune(document.tree(), document.index(), cuts));
    edit.commit(QCoreApplication::translate("Commands", "Prune"));
}

} // namespace espalier

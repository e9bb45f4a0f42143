// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/PropagateBranch.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/PropagateOperation.h"

#include <QCoreApplication>

namespace espalier {

Result<void> propagateBranch(TreeDocument& document, const Propagation& propagation)
{
    Edit edit(document);
    Result<TreeDelta> delta = propagated(document.tree(), document.index(), propagation);
    if (!delta)
        return delta.error();
    const PropagateOperation operation = PropagateOperation::of(document, propagation);
    edit.apply(std::move(*delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Pass On Branch"),
                   [&] { return operation; });
    return {};
}

} // namespace espalier

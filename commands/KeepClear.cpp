// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/KeepClear.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/KeepClearOperation.h"

#include <QCoreApplication>

namespace espalier {

bool keepClear(TreeDocument& document, InternodeId id, float length)
{
    Edit edit(document);
    TreeDelta delta = keepClear(document.tree(), document.index(), id, length);
    if (delta.isEmpty())
        return false;
    const KeepClearOperation operation{InternodeReference::to(document, document.index().axis(id)),
                                       std::clamp(length, 0.0F, kGreatestClearLength)};
    edit.apply(std::move(delta));
    commitRecorded(edit,
                   length > 0.0F ? QCoreApplication::translate("Commands", "Keep Clear")
                                 : QCoreApplication::translate("Commands", "Let Buds Shoot"),
                   [&] { return operation; });
    return true;
}

} // namespace espalier

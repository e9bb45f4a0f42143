// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"
#include "model/document/Edit.h"

namespace espalier {

/// Ends @p edit as one undo step named @p text, with a record for recipes: @p operation() returns the
/// operation that does the same to the tree before the edit. It is called only if the edit has applied
/// deltas.
template <class MakeOperation>
void commitRecorded(Edit& edit, const QString& text, const MakeOperation& operation)
{
    edit.commit(text, edit.deltaCount() > 0
                          ? RecipeOperation(operation()).record(edit.document().parameters())
                          : QByteArray());
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/KeepClear.h"
#include "commands/recipe/KeepClearOperation.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

QString KeepClearOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    return keepClear(document, *id, length)
               ? QString()
               : RecipeText::tr("the branch of internode %1 is already kept clear that far").arg(*id);
}

} // namespace espalier

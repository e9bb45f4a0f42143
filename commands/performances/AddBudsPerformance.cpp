// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/AddBuds.h"
#include "commands/recipe/AddBudsOperation.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

QString AddBudsOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    return addBuds(document, spiralAt(*id)) > 0
               ? QString()
               : RecipeText::tr("internode %1 has no room for buds above the ground").arg(*id);
}

} // namespace espalier

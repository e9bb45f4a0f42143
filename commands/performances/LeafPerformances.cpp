// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/PlaceLeaves.h"
#include "commands/recipe/ArrangeOperation.h"
#include "commands/recipe/PlaceLeafOperation.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

QString PlaceLeafOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    return placeLeaf(document, leafAt(*id)) ? QString()
                                            : RecipeText::tr("internode %1 cannot bear such a leaf").arg(*id);
}

QString ArrangeOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    return arrangeLeaves(document, engine, {.internode = *id, .along = along})
               ? QString()
               : RecipeText::tr("no leaves at internode %1 can be arranged by “%2”")
                     .arg(*id)
                     .arg(nameOf(engine));
}

} // namespace espalier

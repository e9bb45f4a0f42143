// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/WidthGesture.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/SetWidthOperation.h"

namespace espalier {

QString SetWidthOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    const Result<InternodeId> before = from ? from->resolve(document) : id;
    if (!before)
        return before.error().message;
    const auto hasWidth = [&](InternodeId place) { return document.tree().widthConstraint(place) != 0.0F; };
    if (diameter == 0.0 && !hasWidth(*id) && !hasWidth(*before))
        return RecipeText::tr("internode %1 has no width to take away").arg(*id);
    WidthGesture gesture(document, *before);
    gesture.set(*id, diameter);
    gesture.finish();
    return {};
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RemoveLassoOperation.h"

#include "commands/LassoGesture.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

QString RemoveLassoOperation::perform(TreeDocument& document) const
{
    return removeEnvelopes(document) ? QString() : RecipeText::tr("there is no envelope");
}

} // namespace espalier

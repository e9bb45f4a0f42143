// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/SetParametersOperation.h"

namespace espalier {

QString SetParametersOperation::perform(TreeDocument& document) const
{
    return setParameters(document, parameters) ? QString()
                                               : RecipeText::tr("there is no room for more parameter sets");
}

} // namespace espalier

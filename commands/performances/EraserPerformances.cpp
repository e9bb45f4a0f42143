// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/EraseTwigs.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

QString EraseOperation::perform(TreeDocument& document) const
{
    return eraseTwigs(document, *this) ? QString()
                                       : RecipeText::tr("nothing under the brush could be erased");
}

QString ThinOperation::perform(TreeDocument& document) const
{
    return thinTwigs(document, *this) ? QString()
                                      : RecipeText::tr("there were no twigs under the brush to take");
}

} // namespace espalier

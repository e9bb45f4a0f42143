// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"

namespace espalier {

/// Writes a recipe that readRecipe() turns into the same one. The images that it names are written beside it,
/// each once, under names that begin with a part of their hash; an image that lies there already stays.
///
/// An Error if a limit of recipes is exceeded, if another image has the name of one, or if a file cannot be
/// written; its message names the file. The recipe's file is replaced whole or stays as it was.
Result<void> saveRecipe(Recipe recipe, const QString& fileName);

} // namespace espalier

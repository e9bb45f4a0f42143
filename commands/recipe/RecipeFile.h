// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"

namespace espalier {

/// Writes a recipe from which readRecipe() reads the same one. Its images are written beside it, each once,
/// under names that begin with a part of their hash; an image file that exists already is not written again.
///
/// An Error if a limit of recipes is exceeded, if a file with other content has the name of an image, or if a
/// file cannot be written; its message names the file. The recipe's file is replaced as a whole or not at
/// all.
Result<void> saveRecipe(Recipe recipe, const QString& fileName);

} // namespace espalier

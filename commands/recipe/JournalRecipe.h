// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"
#include "model/io/project/Project.h"

namespace espalier {

/// The recipe that makes the tree of @p project with its whole history, and leads to the moment that was
/// shown. It is made of the records that gestures left in the journal (EditRecord). Where the journal was cut
/// within an edit, the recipe does all of that edit and travels back.
///
/// An Error if a record is missing or cannot be read, or if the history does not begin with a seedling: it
/// says how many steps are not known, and which.
Result<Recipe> recipeOf(const Project& project);

} // namespace espalier

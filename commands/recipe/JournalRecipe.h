// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"
#include "model/io/project/Project.h"

namespace espalier {

/// The recipe that makes the tree of @p project with its whole history and ends at the moment that was shown.
/// It is made from the records of gestures in the journal (EditRecord). Where the journal has only the first
/// deltas of an edit, the recipe makes the whole edit and travels back.
///
/// An Error if a record is missing or cannot be read, or if the history does not begin with a seedling. It
/// says how many steps have no record, and which.
Result<Recipe> recipeOf(const Project& project);

} // namespace espalier

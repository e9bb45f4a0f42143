// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"
#include "model/document/TreeDocument.h"
#include "tests/soak/RandomOperations.h"

namespace espalier::test {

/// Does @p operation by the gestures that the program's tools use, as a hand does: in pieces, and by way of
/// what it did not want. What comes of it is what a recipe's player makes of the operation at one go.
void doByHand(TreeDocument& document, const RecipeOperation& operation, RandomOperations& random);

} // namespace espalier::test

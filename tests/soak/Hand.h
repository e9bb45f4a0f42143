// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"
#include "model/document/TreeDocument.h"
#include "tests/soak/RandomOperations.h"

namespace espalier::test {

/// Performs @p operation by the gestures of the program's tools, in pieces and with detours. The result is
/// the one that a recipe's player gets in a single call.
void doByHand(TreeDocument& document, const RecipeOperation& operation, RandomOperations& random);

} // namespace espalier::test

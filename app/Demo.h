// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"
#include "model/base/Error.h"

#include <QStringList>

namespace espalier {

class MainWindow;

/// The recipe that a demonstration plays if none is named.
inline const QString kDemoRecipe = QStringLiteral(":/recipes/oak.json");

/// For displays that no person sees: plays the recipe in the window as fast as possible, then writes
/// first-tree.espalier, .fbx, .obj, .glb and .png into the folder that the program was started in, prints
/// their names on the standard output, and ends the program.
void demonstrateUnseen(MainWindow& window, const Recipe& recipe);

} // namespace espalier

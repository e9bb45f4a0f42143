// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"
#include "model/base/Error.h"

#include <QStringList>

namespace espalier {

class MainWindow;

/// The recipe that a demonstration plays if none is named.
inline const QString kDemoRecipe = QStringLiteral(":/recipes/oak.json");

/// Where nobody looks: plays the recipe in the window as fast as it goes, then writes first-tree.espalier,
/// .fbx, .obj, .glb and .png into the folder that the program was started in, says so on the standard output,
/// and ends the program.
void demonstrateUnseen(MainWindow& window, const Recipe& recipe);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace espalier {

/// The view from which pictures of the recipe's tree are taken.
struct RecipeCamera {
    QString view; ///< front, side, top or three-quarter; empty if the recipe has none
    bool operator==(const RecipeCamera&) const = default;
};

/// All operations that make a tree, from the seedling on.
struct Recipe {
    QString name;
    QString description;
    std::uint64_t seed = 1;
    TreeParameters parameters;
    RecipeCamera camera;
    std::vector<RecipeOperation> operations;
    bool operator==(const Recipe&) const = default;
};

/// Reads a recipe. Unknown keys, wrong types, values beyond the limits and invalid JSON give an error that
/// names the place, such as "operations[3].samples[17]: the time does not go forwards".
///
/// Images are files, named relative to @p folder; if that is empty, a recipe can have none. Leaves with a new
/// image take its aspect and colours (see adoptImage()), except where the same parameters say otherwise.
Result<Recipe> parseRecipe(const QByteArray& json, const QString& folder = {});
/// The same from a file; the error begins with the file's name. A table of a measured skeleton (*.csv) is
/// read as a recipe that imports it.
Result<Recipe> readRecipe(const QString& fileName);

/// JSON from which parseRecipe() reads the same recipe, to the last bit except the sign of zeros.
/// Precondition: the recipe is within the limits, and its direction weights sum to 1 (see
/// normaliseDirectionWeights). Images are named, not written (see saveRecipe()). A short recipe is indented,
/// a longer one (see recipeLimits::kIndentedBytes) is a single line.
QByteArray writeRecipe(const Recipe& recipe);

} // namespace espalier

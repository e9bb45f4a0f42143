// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace espalier {

/// From where a picture is taken.
struct RecipeCamera {
    QString view; ///< front, side, top, three-quarter; empty for none said
    bool operator==(const RecipeCamera&) const = default;
};

/// What a person did to a tree, from the seedling on.
struct Recipe {
    QString name;
    QString description;
    std::uint64_t seed = 1;
    TreeParameters parameters;
    RecipeCamera camera;
    std::vector<RecipeOperation> operations;
    bool operator==(const Recipe&) const = default;
};

/// Reads a recipe. Unknown keys, wrong types, values beyond the limits and JSON that is none give an error
/// that names the place, such as "operations[3].samples[17]: the time does not go forwards".
///
/// Images are files, named relative to @p folder; without one a recipe can have none. Leaves that get an
/// image have it as it is (see adoptImage()), but for what the same parameters say.
Result<Recipe> parseRecipe(const QByteArray& json, const QString& folder = {});
/// The same from a file, whose name the error begins with.
Result<Recipe> readRecipe(const QString& fileName);

/// The JSON that parseRecipe turns into the same recipe, to the last bit, but for the sign of zeros.
/// Precondition: the recipe is within the limits, and its direction weights sum to 1 (see
/// normaliseDirectionWeights). Images are named, not written: their files must lie where they are looked for.
/// A short recipe is indented, a long one (see recipeLimits::kIndentedBytes) is a single line.
QByteArray writeRecipe(const Recipe& recipe);

} // namespace espalier

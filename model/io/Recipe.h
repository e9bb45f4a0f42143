// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/growth/BrushSample.h"
#include "model/tree/Parameters.h"

#include <QByteArray>
#include <QString>

#include <variant>
#include <vector>

namespace espalier {

/// What a person did, as data. One struct an operation; resources/recipe.schema.json describes the JSON.
struct SetParametersOperation {
    TreeParameters parameters; ///< Complete: those before, with the recipe's changes
};
struct BrushStrokeOperation {
    std::vector<BrushSample> samples; ///< At least one, times ascending
};
struct GrowOperation {
    int steps = 1; ///< 1...10,000
};
struct UndoOperation {
    int count = 1;
};
struct RedoOperation {
    int count = 1;
};
using RecipeOperation =
    std::variant<SetParametersOperation, BrushStrokeOperation, GrowOperation, UndoOperation, RedoOperation>;

/// From where a picture is taken.
struct RecipeCamera {
    QString view; ///< front, side, top, three-quarter; empty for none said
};

struct Recipe {
    QString name;
    QString description;
    std::uint64_t seed = 1;
    TreeParameters parameters;
    RecipeCamera camera;
    std::vector<RecipeOperation> operations;
};

/// Reads a recipe. Unknown keys, values out of range, too many samples (1,000,000 in all) and JSON that is none give an error that names the
/// place, such as "operations[3].samples[17]: the time goes backwards".
Result<Recipe> parseRecipe(const QByteArray& json);
Result<Recipe> readRecipe(const QString& fileName);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/base/Ids.h"
#include "model/growth/BrushSample.h"
#include "model/growth/Competition.h"
#include "model/tree/LassoStroke.h"
#include "model/tree/Parameters.h"

#include <QByteArray>
#include <QString>

#include <variant>
#include <vector>

namespace espalier {

/// What a person did, as data. One struct an operation; docs/recipes.md and resources/recipe.schema.json
/// describe the JSON.
struct SetParametersOperation {
    TreeParameters parameters; ///< Complete: those before, with the recipe's changes
    bool operator==(const SetParametersOperation&) const = default;
};
struct BrushStrokeOperation {
    std::vector<BrushSample> samples; ///< At least one, times ascending
    Competitors competitors{};        ///< Which buds grow
    bool operator==(const BrushStrokeOperation&) const = default;
};
struct GrowOperation {
    int steps = 1; ///< 1...10,000
    Competitors competitors{};
    bool operator==(const GrowOperation&) const = default;
};
struct PruneOperation {
    std::vector<InternodeId> internodes; ///< At least one; each goes with all that it carries
    bool operator==(const PruneOperation&) const = default;
};
/// Goes back in the tree's history by so many growth steps and edits, or forth again.
struct TravelOperation {
    int by = -1; ///< Not 0; at most 1,000,000 either way; what lies beyond the history's ends is left out
    bool operator==(const TravelOperation&) const = default;
};
struct UndoOperation {
    int count = 1; ///< 1...100,000
    bool operator==(const UndoOperation&) const = default;
};
struct RedoOperation {
    int count = 1; ///< 1...100,000
    bool operator==(const RedoOperation&) const = default;
};
struct BendOperation {
    struct Handle {
        InternodeId internode = 0;
        double along = 1.0;         ///< 0...1 from its lower to its upper node
        Vec3 target = Vec3::Zero(); ///< m
        bool operator==(const Handle&) const = default;
    };
    InternodeId base = 0;
    std::vector<Handle> handles; ///< 1...100
    double bending = 1.0;        ///< Weight, 0.01...100
    double stretching = 1.0;     ///< Weight, 0.01...100
    bool operator==(const BendOperation&) const = default;
};
struct SetWidthOperation {
    InternodeId internode = 0;
    double diameter = 0.0; ///< m, 0...100; 0 takes the constraint away
    bool operator==(const SetWidthOperation&) const = default;
};
struct LassoOperation {
    LassoStroke stroke;        ///< Raw: any number of points from 3 on
    Competitors competitors{}; ///< The buds that may grow
    bool operator==(const LassoOperation&) const = default;
};
struct RegrowOperation {
    bool operator==(const RegrowOperation&) const = default;
};
struct RemoveLassoOperation {
    bool operator==(const RemoveLassoOperation&) const = default;
};
using RecipeOperation =
    std::variant<SetParametersOperation, BrushStrokeOperation, GrowOperation, PruneOperation, TravelOperation,
                 UndoOperation, RedoOperation, BendOperation, SetWidthOperation, LassoOperation,
                 RegrowOperation, RemoveLassoOperation>;

/// From where a picture is taken.
struct RecipeCamera {
    QString view; ///< front, side, top, three-quarter; empty for none said
    bool operator==(const RecipeCamera&) const = default;
};

struct Recipe {
    QString name;
    QString description;
    std::uint64_t seed = 1;
    TreeParameters parameters;
    RecipeCamera camera;
    std::vector<RecipeOperation> operations;
    bool operator==(const Recipe&) const = default;
};

/// The limits of a recipe beside those of the parameters (see visitParameters); resources/recipe.schema.json
/// has them too.
namespace recipeLimits {
/// Its value is the version.
inline constexpr QLatin1StringView kVersionKey("espalier-recipe");
inline constexpr int kVersion = 1;
inline constexpr double kCoordinate = 1000.0;    ///< m, either way
inline constexpr double kRadius = 100.0;         ///< m
inline constexpr double kStrokeTime = 600.0;     ///< s
inline constexpr qsizetype kSamples = 1'000'000; ///< in all, points of lassos among them
inline constexpr qsizetype kOperations = 100'000;
inline constexpr int kGrowSteps = 10'000;    ///< an operation
inline constexpr int kTravel = 1'000'000;    ///< an operation
inline constexpr int kUndoCount = 100'000;   ///< an operation
inline constexpr qsizetype kCuts = 100'000;  ///< an operation
inline constexpr qsizetype kHandles = 100;   ///< of a bend
inline constexpr double kLeastWeight = 0.01; ///< of bending and stretching
inline constexpr double kGreatestWeight = 100.0;
inline constexpr double kDiameter = 100.0; ///< m
inline constexpr std::int64_t kInternode = 0xffff'fffe;
inline constexpr qsizetype kImages = 64; ///< Files
inline constexpr qsizetype kBytes = 64 << 20;
} // namespace recipeLimits

/// Reads a recipe. Unknown keys, wrong types, values beyond the limits and JSON that is none give an error
/// that names the place, such as "operations[3].samples[17]: the time does not go forwards".
///
/// Images are files, named relative to @p folder; without one a recipe can have none. Leaves that get an
/// image have it as it is (see adoptImage()), but for what the same parameters say.
Result<Recipe> parseRecipe(const QByteArray& json, const QString& folder = {});
/// The same from a file, whose name the error begins with.
Result<Recipe> readRecipe(const QString& fileName);

/// The JSON that parseRecipe turns into the same recipe, to the last bit. Precondition: the recipe is within
/// the limits, and its direction weights sum to 1 (see normaliseDirectionWeights). Images are named, not
/// written: their files must lie where they are looked for.
QByteArray writeRecipe(const Recipe& recipe);

} // namespace espalier

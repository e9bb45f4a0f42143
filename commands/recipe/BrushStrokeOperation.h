// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/growth/BrushSample.h"

#include <optional>
#include <vector>

namespace espalier {

/// A stroke of the brush.
struct BrushStrokeOperation {
    static constexpr QLatin1StringView kName{"brushStroke"};
    static constexpr double kGreatestTime = 600.0;   ///< s
    static constexpr double kGreatestRadius = 100.0; ///< m

    std::vector<BrushSample> samples; ///< At least one, times ascending
    BudReference only{};              ///< Which buds grow
    /// When the stroke was broken off on the way to the last sample, s; nothing if it was not.
    std::optional<double> until{};

    static BrushStrokeOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    /// What the brush covers.
    Box3 reach() const;
    bool operator==(const BrushStrokeOperation&) const = default;
};

} // namespace espalier

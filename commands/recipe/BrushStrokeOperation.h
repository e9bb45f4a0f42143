// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/growth/BrushGrowth.h"
#include "model/growth/StrokePlacement.h"

#include <optional>
#include <vector>

namespace espalier {

/// A stroke of the brush.
struct BrushStrokeOperation {
    static constexpr QLatin1StringView kName{"brushStroke"};
    static constexpr double kGreatestTime = 600.0;   ///< s
    static constexpr double kGreatestRadius = 100.0; ///< m

    std::vector<BrushSample> samples; ///< At least one, by ascending time
    BudReference only{};              ///< Which buds grow
    /// The time at which the stroke ended on the way to the last sample, s; empty if it ended at that sample.
    std::optional<double> until{};
    StrokeEnd end = StrokeEnd::AtRelease;
    StrokePlacement placement{}; ///< Its point within recipeLimits::kCoordinate

    static BrushStrokeOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    /// The space that the brush passes through, m.
    Box3 reach() const;
    bool operator==(const BrushStrokeOperation&) const = default;
};

} // namespace espalier

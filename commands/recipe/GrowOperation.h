// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Growth without a brush. It ends early when nothing grows any more.
struct GrowOperation {
    static constexpr QLatin1StringView kName{"grow"};
    static constexpr int kMostSteps = 10'000;

    int steps = 1;       ///< 1...kMostSteps
    BudReference only{}; ///< Which buds grow

    static GrowOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    bool operator==(const GrowOperation&) const = default;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Travels in the tree's history by a number of deltas (growth steps and edits), back or forth.
struct TravelOperation {
    static constexpr QLatin1StringView kName{"travel"};
    static constexpr int kFarthest = 1'000'000;

    int by = -1; ///< -kFarthest...kFarthest, not 0; a travel stops at the ends of the history

    static TravelOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const TravelOperation&) const = default;
};

} // namespace espalier

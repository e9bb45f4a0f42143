// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Goes back in the tree's history by so many growth steps and edits, or forth again.
struct TravelOperation {
    static constexpr QLatin1StringView kName{"travel"};
    static constexpr int kFarthest = 1'000'000;

    int by = -1; ///< -kFarthest...kFarthest, not 0; what lies beyond the history's ends is left out

    static TravelOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const TravelOperation&) const = default;
};

} // namespace espalier

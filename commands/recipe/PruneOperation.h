// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

#include <vector>

namespace espalier {

/// Removes branches.
struct PruneOperation {
    static constexpr QLatin1StringView kName{"prune"};
    static constexpr qsizetype kMostCuts = 100'000;

    std::vector<InternodeReference> internodes; ///< 1...kMostCuts; each is removed with all that it carries

    static PruneOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const PruneOperation&) const = default;
};

} // namespace espalier

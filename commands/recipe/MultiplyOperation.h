// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

#include <cstdint>

namespace espalier {

/// Adds branches to a branch by the example of those that it carries (commands/MultiplyBranch.h).
struct MultiplyOperation {
    static constexpr QLatin1StringView kName{"multiply"};
    static constexpr int kMostCount = 1000;

    InternodeReference internode; ///< Any of the branch
    int count = 1;                ///< 1...kMostCount
    std::uint64_t seed = 1;

    static MultiplyOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const MultiplyOperation&) const = default;
};

} // namespace espalier

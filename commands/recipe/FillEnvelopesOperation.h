// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/tree/LassoStroke.h"

#include <optional>
#include <vector>

namespace espalier {

/// Lets the tree that stands fill envelopes: those in force, or others, which take their place.
struct FillEnvelopesOperation {
    static constexpr QLatin1StringView kName{"fillEnvelopes"};
    static constexpr qsizetype kMostEnvelopes = 10'000;

    std::optional<std::vector<LassoStroke>> envelopes; ///< Simplified; nothing for those in force
    /// Complete; those that the envelopes come into force with. Of no meaning without envelopes.
    TreeParameters parameters{};
    BudReference only{};        ///< Which buds grow
    std::optional<int> steps{}; ///< At most so many; nothing for all there are

    static FillEnvelopesOperation read(JsonReader& reader, RecipeReading& reading);
    /// Only what differs from the parameters before; @p writing has these from then on.
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    bool operator==(const FillEnvelopesOperation&) const = default;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/tree/LassoStroke.h"

#include <optional>
#include <vector>

namespace espalier {

/// Lets the present tree fill envelopes: those in force, or others, which replace them.
struct FillEnvelopesOperation {
    static constexpr QLatin1StringView kName{"fillEnvelopes"};
    static constexpr qsizetype kMostEnvelopes = 10'000;

    std::optional<std::vector<LassoStroke>> envelopes; ///< Simplified; empty for those in force
    /// The complete parameters that come into force with the envelopes; ignored without envelopes.
    TreeParameters parameters{};
    BudReference only{};        ///< Which buds grow
    std::optional<int> steps{}; ///< At most this many; empty for growth to its end

    static FillEnvelopesOperation read(JsonReader& reader, RecipeReading& reading);
    /// Writes only what differs from @p writing's parameters, and sets these to its own.
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    bool operator==(const FillEnvelopesOperation&) const = default;
};

} // namespace espalier

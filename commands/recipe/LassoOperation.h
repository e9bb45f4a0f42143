// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/tree/LassoStroke.h"

#include <optional>

namespace espalier {

/// Draws an envelope and lets the tree fill it.
struct LassoOperation {
    static constexpr QLatin1StringView kName{"lasso"};

    LassoStroke stroke;         ///< Not simplified: kLeastLassoPoints points or more
    BudReference only{};        ///< Which buds grow
    std::optional<int> steps{}; ///< At most this many; empty for growth to its end

    static LassoOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    /// The points of the stroke, and the base of the tree.
    Box3 reach() const;
    bool operator==(const LassoOperation&) const = default;
};

} // namespace espalier

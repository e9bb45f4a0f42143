// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Redoes commands that were undone.
struct RedoOperation {
    static constexpr QLatin1StringView kName{"redo"};
    static constexpr int kMostCount = 100'000;

    int count = 1; ///< Commands, 1...kMostCount

    static RedoOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const RedoOperation&) const = default;
};

} // namespace espalier

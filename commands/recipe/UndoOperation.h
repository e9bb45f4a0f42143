// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Undoes the last commands.
struct UndoOperation {
    static constexpr QLatin1StringView kName{"undo"};
    static constexpr int kMostCount = 100'000;

    int count = 1; ///< Commands, 1...kMostCount

    static UndoOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const UndoOperation&) const = default;
};

} // namespace espalier

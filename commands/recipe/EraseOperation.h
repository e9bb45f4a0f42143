// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"
#include "commands/recipe/SweptTwigs.h"

namespace espalier {

/// A stroke of the eraser: thin wood and placed leaves that appear under it go.
struct EraseOperation {
    static constexpr QLatin1StringView kName{"erase"};

    SweptTwigs twigs;

    static EraseOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const EraseOperation&) const = default;
};

} // namespace espalier

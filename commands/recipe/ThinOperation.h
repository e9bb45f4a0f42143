// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"
#include "commands/recipe/SweptTwigs.h"

namespace espalier {

/// A stroke of the brush that thins out: a share of the twigs that appear under it goes (Thinning).
struct ThinOperation {
    static constexpr QLatin1StringView kName{"thin"};
    static constexpr double kShare = 0.3; ///< Unless the recipe says otherwise

    SweptTwigs twigs;
    double share = kShare; ///< 0...1

    static ThinOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const ThinOperation&) const = default;
};

} // namespace espalier

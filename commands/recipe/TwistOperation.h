// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/shape/Twist.h"

namespace espalier {

/// Twists the strands of a branch, or takes their twist away.
struct TwistOperation {
    static constexpr QLatin1StringView kName{"twist"};
    static constexpr double kMostAngle = 180.0;

    InternodeReference internode; ///< The lowest one that is twisted
    double angle = 0.0;           ///< Degrees from node to node, within ±kMostAngle; 0 takes the twist away
    TwistScope scope = TwistScope::Branch;

    static TwistOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const TwistOperation&) const = default;
};

} // namespace espalier

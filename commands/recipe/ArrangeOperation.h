// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/sketch/LeafSuggestions.h"

namespace espalier {

/// Goes on with placed leaves as one of the engines of LeafSuggestions does.
struct ArrangeOperation {
    static constexpr QLatin1StringView kName{"arrange"};

    LeafEngine engine = LeafEngine::AddToWhorl;
    InternodeReference internode; ///< Near the leaf that was edited last
    float along = 1.0F;           ///< 0...1 on the internode

    static ArrangeOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const ArrangeOperation&) const = default;

    /// The name of an engine in recipes.
    static QLatin1StringView nameOf(LeafEngine engine);
};

} // namespace espalier

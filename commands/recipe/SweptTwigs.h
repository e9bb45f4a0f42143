// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeReading.h"
#include "model/shape/SeenWood.h"

#include <QJsonObject>

#include <vector>

namespace espalier {

/// What the strokes of the brushes that take twigs have in common: where they passed, and which wood they
/// take.
struct SweptTwigs {
    static constexpr double kThickest = 0.15;        ///< Unless the recipe says otherwise
    static constexpr double kGreatestRadius = 100.0; ///< m

    std::vector<Sweep> sweeps;   ///< One or more
    double thickest = kThickest; ///< TwigRule, 0...1
    SweepDepth depth = SweepDepth::All;

    /// Reads the members "sweeps", "thickest" and "nearSide" of @p reader's object.
    static SweptTwigs read(JsonReader& reader, RecipeReading& reading);
    /// Adds these members.
    void write(QJsonObject& json) const;
    bool operator==(const SweptTwigs&) const = default;
};

} // namespace espalier

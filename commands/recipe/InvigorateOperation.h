// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/HeldTime.h"
#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Adds vigour to a branch as long as it is held: its subtree grows.
struct InvigorateOperation {
    static constexpr QLatin1StringView kName{"invigorate"};

    InternodeReference internode;
    double seconds = 1.0; ///< That it is held, 0...kMostHeldSeconds

    static InvigorateOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    bool operator==(const InvigorateOperation&) const = default;
};

} // namespace espalier

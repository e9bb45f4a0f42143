// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/HeldTime.h"
#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Takes the youngest internodes of a branch away as long as it is held.
struct ReduceOperation {
    static constexpr QLatin1StringView kName{"reduce"};

    InternodeReference internode;
    double seconds = 1.0; ///< That it is held, 0...kMostHeldSeconds

    static ReduceOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    bool operator==(const ReduceOperation&) const = default;
};

} // namespace espalier

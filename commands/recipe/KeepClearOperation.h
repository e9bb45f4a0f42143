// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/tree/TreeTables.h"

namespace espalier {

/// Keeps a trunk or a branch clear of shoots from its base on (keepClear).
struct KeepClearOperation {
    static constexpr QLatin1StringView kName{"keepClear"};

    InternodeReference internode; ///< Any on the axis
    float length = 0.0F;          ///< m, 0...kGreatestClearLength; 0 lets buds shoot again

    static KeepClearOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const KeepClearOperation&) const = default;
};

} // namespace espalier

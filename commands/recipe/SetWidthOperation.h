// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Sets or removes the width of an internode.
struct SetWidthOperation {
    static constexpr QLatin1StringView kName{"setWidth"};

    InternodeReference internode;
    double diameter = 0.0; ///< m, 0...kGreatestDiameter; 0 removes the width
    /// The internode that the width is moved from; empty if it is not moved.
    std::optional<InternodeReference> from{};

    static SetWidthOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const SetWidthOperation&) const = default;
};

} // namespace espalier

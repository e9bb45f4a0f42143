// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"
#include "commands/recipe/TreeFigure.h"

namespace espalier {

/// Gives the seedling's tree the figure of two strokes (commands/ReproduceTree.h).
struct ReproduceOperation {
    static constexpr QLatin1StringView kName{"reproduce"};

    TreeFigure figure; ///< Strokes of a point or more

    static ReproduceOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const ReproduceOperation&) const = default;
};

} // namespace espalier

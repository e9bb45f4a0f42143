// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"
#include "commands/recipe/TreeSketch.h"

namespace espalier {

/// Makes a tree out of the seedling from a drawing (commands/DrawSketch.h).
struct SketchOperation {
    static constexpr QLatin1StringView kName{"sketch"};

    TreeSketch sketch; ///< 1...kMostSketchStrokes strokes of a point or more

    static SketchOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const SketchOperation&) const = default;
};

} // namespace espalier

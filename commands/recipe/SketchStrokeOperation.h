// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BranchStroke.h"
#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

#include <optional>
#include <vector>

namespace espalier {

/// Draws a branch.
struct SketchStrokeOperation {
    static constexpr QLatin1StringView kName{"sketchStroke"};
    static constexpr qsizetype kMostRadii = 1000;

    LassoStroke stroke;                     ///< Two points or more
    std::optional<InternodeReference> on{}; ///< BranchStroke::base
    float along = 1.0F;                     ///< On that internode, 0...1
    std::vector<float> radii{};             ///< m, at most kMostRadii
    std::optional<InternodeReference> replaces{};
    bool mirror = false;

    /// Precondition: the document has the stroke's internodes.
    static SketchStrokeOperation of(const TreeDocument& document, const BranchStroke& stroke);
    static SketchStrokeOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const SketchStrokeOperation&) const = default;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"
#include "model/sketch/DepthInference.h"

namespace espalier {

/// Gives a drawn tree depth.
struct InferOperation {
    static constexpr QLatin1StringView kName{"infer"};

    DepthOptions options{}; ///< Those that readDepth() reads

    static InferOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const InferOperation&) const = default;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"
#include "model/io/import/Skeleton.h"

namespace espalier {

/// Makes the trees of a measured skeleton out of the seedling.
struct ImportOperation {
    static constexpr QLatin1StringView kName{"import"};

    Skeleton skeleton; ///< 1...kMostSegments

    /// The skeleton is in the member "segments", or in the table of the file that "file" names.
    static ImportOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const ImportOperation&) const = default;
};

} // namespace espalier

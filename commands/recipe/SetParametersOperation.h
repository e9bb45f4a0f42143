// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Puts parameters in force.
struct SetParametersOperation {
    static constexpr QLatin1StringView kName{"setParameters"};

    TreeParameters parameters; ///< Complete: those in force before, with the recipe's changes

    static SetParametersOperation read(JsonReader& reader, RecipeReading& reading);
    /// Writes only what differs from @p writing's parameters, and sets these to its own.
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const SetParametersOperation&) const = default;
};

/// What differs from @p base, as RecipeReading::readParameters() reads it. Images are written by name. With a
/// leaf image, the parameters that adoptImage() would set are written as well.
QJsonObject parametersToJson(const TreeParameters& parameters, const TreeParameters& base);

} // namespace espalier

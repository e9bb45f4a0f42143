// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Puts parameters in force.
struct SetParametersOperation {
    static constexpr QLatin1StringView kName{"setParameters"};

    TreeParameters parameters; ///< Complete: those before, with the recipe's changes

    static SetParametersOperation read(JsonReader& reader, RecipeReading& reading);
    /// Only what differs from the parameters before; @p writing has these from then on.
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const SetParametersOperation&) const = default;
};

/// What differs from @p base, as RecipeReading::readParameters() takes it. Images are named; what they bring
/// along unless it is said (see adoptImage()) is said.
QJsonObject parametersToJson(const TreeParameters& parameters, const TreeParameters& base);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/GrowOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kStepsKey("steps");

} // namespace

GrowOperation GrowOperation::read(JsonReader& reader, RecipeReading&)
{
    return {static_cast<int>(reader.integer(kStepsKey, 1, kMostSteps)), BudReference::read(reader)};
}

QJsonObject GrowOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kStepsKey, steps}};
    only.write(json);
    return json;
}

} // namespace espalier

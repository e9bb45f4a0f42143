// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/TravelOperation.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kByKey("by");

} // namespace

TravelOperation TravelOperation::read(JsonReader& reader, RecipeReading&)
{
    const auto by = reader.integer(kByKey, -kFarthest, kFarthest);
    if (by == 0)
        reader.fail(kByKey, RecipeText::tr("a number other than 0 is expected"));
    return {static_cast<int>(by)};
}

QJsonObject TravelOperation::write(RecipeWriting&) const
{
    return {{kByKey, by}};
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/TravelOperation.h"

#include <QCoreApplication>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Recipe)
};

constexpr QLatin1StringView kByKey("by");

} // namespace

TravelOperation TravelOperation::read(JsonReader& reader, RecipeReading&)
{
    const auto by = reader.integer(kByKey, -kFarthest, kFarthest);
    if (by == 0)
        reader.fail(kByKey, Text::tr("a number other than 0 is expected"));
    return {static_cast<int>(by)};
}

QJsonObject TravelOperation::write(RecipeWriting&) const
{
    return {{kByKey, by}};
}

} // namespace espalier

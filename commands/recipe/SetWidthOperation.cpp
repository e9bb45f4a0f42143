// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SetWidthOperation.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kWidthInternodeKey("internode");
constexpr QLatin1StringView kDiameterKey("diameter");
constexpr QLatin1StringView kFromKey("from");

} // namespace

SetWidthOperation SetWidthOperation::read(JsonReader& reader, RecipeReading&)
{
    SetWidthOperation width{InternodeReference::read(reader, kWidthInternodeKey),
                            reader.number(kDiameterKey, 0.0, kGreatestDiameter)};
    if (reader.has(kFromKey))
        width.from = InternodeReference::read(reader, kFromKey);
    return width;
}

QJsonObject SetWidthOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kWidthInternodeKey, internode.toJson()}, {kDiameterKey, diameter}};
    if (from)
        json[kFromKey] = from->toJson();
    return json;
}

} // namespace espalier

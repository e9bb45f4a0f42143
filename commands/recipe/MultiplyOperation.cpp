// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/MultiplyOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kMultipliedKey("internode");
constexpr QLatin1StringView kMultiplyCountKey("count");
constexpr QLatin1StringView kMultiplySeedKey("seed");

} // namespace

MultiplyOperation MultiplyOperation::read(JsonReader& reader, RecipeReading&)
{
    return {.internode = InternodeReference::read(reader, kMultipliedKey),
            .count = static_cast<int>(reader.integer(kMultiplyCountKey, 1, kMostCount, 1)),
            .seed = reader.seed(kMultiplySeedKey, 1)};
}

QJsonObject MultiplyOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kMultipliedKey, internode.toJson()}};
    if (count != 1)
        json[kMultiplyCountKey] = count;
    if (seed != 1)
        json[kMultiplySeedKey] = seedToJson(seed);
    return json;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/KeepClearOperation.h"

#include "commands/recipe/RecipeJson.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kClearInternodeKey("internode");
constexpr QLatin1StringView kClearLengthKey("length");

} // namespace

KeepClearOperation KeepClearOperation::read(JsonReader& reader, RecipeReading&)
{
    return {
        InternodeReference::read(reader, kClearInternodeKey),
        static_cast<float>(reader.number(kClearLengthKey, 0.0, static_cast<double>(kGreatestClearLength)))};
}

QJsonObject KeepClearOperation::write(RecipeWriting&) const
{
    return {{kClearInternodeKey, internode.toJson()}, {kClearLengthKey, shortestDouble(length)}};
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/ReduceOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kReduceInternodeKey("internode");
constexpr QLatin1StringView kReduceSecondsKey("seconds");

} // namespace

ReduceOperation ReduceOperation::read(JsonReader& reader, RecipeReading&)
{
    return {InternodeReference::read(reader, kReduceInternodeKey),
            reader.number(kReduceSecondsKey, 0.0, kMostHeldSeconds)};
}

QJsonObject ReduceOperation::write(RecipeWriting&) const
{
    return {{kReduceInternodeKey, internode.toJson()}, {kReduceSecondsKey, seconds}};
}

} // namespace espalier

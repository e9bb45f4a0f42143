// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/InvigorateOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kInvigorateInternodeKey("internode");
constexpr QLatin1StringView kInvigorateSecondsKey("seconds");

} // namespace

InvigorateOperation InvigorateOperation::read(JsonReader& reader, RecipeReading&)
{
    return {InternodeReference::read(reader, kInvigorateInternodeKey),
            reader.number(kInvigorateSecondsKey, 0.0, kMostHeldSeconds)};
}

QJsonObject InvigorateOperation::write(RecipeWriting&) const
{
    return {{kInvigorateInternodeKey, internode.toJson()}, {kInvigorateSecondsKey, seconds}};
}

} // namespace espalier

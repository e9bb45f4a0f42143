// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/ThinOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kThinShareKey("share");

} // namespace

ThinOperation ThinOperation::read(JsonReader& reader, RecipeReading& reading)
{
    return {SweptTwigs::read(reader, reading), reader.number(kThinShareKey, 0.0, 1.0, kShare)};
}

QJsonObject ThinOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kThinShareKey, share}};
    twigs.write(json);
    return json;
}

} // namespace espalier

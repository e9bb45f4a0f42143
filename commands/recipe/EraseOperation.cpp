// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/EraseOperation.h"

namespace espalier {

EraseOperation EraseOperation::read(JsonReader& reader, RecipeReading& reading)
{
    return {SweptTwigs::read(reader, reading)};
}

QJsonObject EraseOperation::write(RecipeWriting&) const
{
    QJsonObject json;
    twigs.write(json);
    return json;
}

} // namespace espalier

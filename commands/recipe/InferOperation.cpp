// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/InferOperation.h"

#include "commands/recipe/DepthJson.h"

namespace espalier {

InferOperation InferOperation::read(JsonReader& reader, RecipeReading&)
{
    return {.options = readDepth(reader)};
}

QJsonObject InferOperation::write(RecipeWriting&) const
{
    QJsonObject json;
    writeDepth(json, options);
    return json;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SetParametersOperation.h"

#include "commands/recipe/RecipeText.h"
#include "model/io/ParametersJson.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kParametersKey("parameters");

} // namespace

SetParametersOperation SetParametersOperation::read(JsonReader& reader, RecipeReading& reading)
{
    if (!reader.has(kParametersKey))
        reader.fail(kParametersKey, RecipeText::tr("it is missing"));
    const Result<void> read =
        reading.readParameters(reader.object(kParametersKey), reader.placeOf(kParametersKey));
    if (!read)
        reader.fail(read.error());
    return {reading.parameters()};
}

QJsonObject SetParametersOperation::write(RecipeWriting& writing) const
{
    const QJsonObject changes = parametersToJson(parameters, writing.parameters);
    writing.parameters = parameters;
    return {{kParametersKey, changes}};
}

QJsonObject parametersToJson(const TreeParameters& parameters, const TreeParameters& base)
{
    QJsonObject json = toJson(parameters, base, &ImageAsset::name);
    const QLatin1StringView key("leaves");
    QJsonObject leaves = json.value(key).toObject();
    if (!leaves.value(QLatin1StringView("image")).toString().isEmpty()) {
        const QJsonObject all = toJson(parameters).value(key).toObject();
        for (const char* name : {"aspect", "hue", "saturation", "brightness"})
            leaves[QLatin1StringView(name)] = all[QLatin1StringView(name)];
        json[key] = leaves;
    }
    return json;
}

} // namespace espalier

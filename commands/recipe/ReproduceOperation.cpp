// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/ReproduceOperation.h"

#include "commands/recipe/StrokeJson.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kTrunkKey("trunk");
constexpr QLatin1StringView kSilhouetteKey("silhouette");
constexpr QLatin1StringView kFigureAzimuthKey("azimuth");

} // namespace

ReproduceOperation ReproduceOperation::read(JsonReader& reader, RecipeReading& reading)
{
    const auto stroke = [&](QLatin1StringView key) {
        return readStroke(reader, reading, key, reader.placeOf(key), reader.array(key));
    };
    ReproduceOperation operation;
    operation.figure.trunk = stroke(kTrunkKey);
    operation.figure.silhouette = stroke(kSilhouetteKey);
    operation.figure.azimuth =
        reader.number(kFigureAzimuthKey, -TreeFigure::kMostAzimuth, TreeFigure::kMostAzimuth, 0.0);
    return operation;
}

QJsonObject ReproduceOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kTrunkKey, strokeToJson(figure.trunk)},
                     {kSilhouetteKey, strokeToJson(figure.silhouette)}};
    if (figure.azimuth != 0.0)
        json[kFigureAzimuthKey] = figure.azimuth;
    return json;
}

} // namespace espalier

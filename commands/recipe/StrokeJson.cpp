// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/StrokeJson.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

std::vector<Vec2> readStroke(JsonReader& reader, RecipeReading& reading, QLatin1StringView key,
                             const QString& place, const QJsonArray& array)
{
    std::vector<Vec2> stroke;
    if (array.isEmpty())
        reader.fail(inputError(place, RecipeText::tr("a stroke needs at least one point")));
    if (!reading.admitSamples(reader, key, array.size()))
        return stroke;
    for (qsizetype i = 0; i < array.size(); ++i) {
        const auto point = vectorFromJson<2>(array.at(i).toArray(), recipeLimits::kCoordinate);
        if (!point) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(place).arg(i),
                                   RecipeText::tr("two numbers within ±%1 are expected, right and up, in m")
                                       .arg(recipeLimits::kCoordinate)));
            break;
        }
        stroke.push_back(*point);
    }
    return stroke;
}

QJsonArray strokeToJson(const std::vector<Vec2>& stroke)
{
    QJsonArray points;
    for (const Vec2& point : stroke)
        points.append(toJson(point));
    return points;
}

} // namespace espalier

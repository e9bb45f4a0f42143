// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/LassoJson.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kLassoStepsKey("steps");
constexpr QLatin1StringView kPointsKey("points");

struct PlaneVector {
    QLatin1StringView key;
    Vec3 LassoStroke::*vector;
};
constexpr PlaneVector kPlane[] = {{QLatin1StringView("origin"), &LassoStroke::origin},
                                  {QLatin1StringView("right"), &LassoStroke::right},
                                  {QLatin1StringView("up"), &LassoStroke::up}};

} // namespace

LassoStroke readLasso(JsonReader& reader, RecipeReading& reading, qsizetype least)
{
    LassoStroke stroke;
    for (const auto& [key, vector] : kPlane) {
        if (!reader.has(key))
            continue;
        if (const auto read = vectorFromJson<3>(reader.array(key), recipeLimits::kCoordinate))
            stroke.*vector = *read;
        else
            reader.fail(
                key, RecipeText::tr("three numbers within ±%1 are expected").arg(recipeLimits::kCoordinate));
    }
    if (!isLasso(stroke))
        reader.fail(QLatin1StringView("up"),
                    RecipeText::tr("right and up must have length 1 and be at right angles"));

    const QJsonArray array = reader.array(kPointsKey);
    if (array.size() < least)
        reader.fail(kPointsKey, least == kLeastLassoPoints
                                    ? RecipeText::tr("a lasso needs at least three points")
                                    : RecipeText::tr("a stroke needs at least %1 points").arg(least));
    if (!reading.admitSamples(reader, kPointsKey, array.size()))
        return stroke;
    stroke.points.reserve(static_cast<std::size_t>(array.size()));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const auto point = vectorFromJson<2>(array.at(i).toArray(), recipeLimits::kCoordinate);
        if (!point) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kPointsKey)).arg(i),
                                   RecipeText::tr("two numbers within ±%1 are expected, right and up, in m")
                                       .arg(recipeLimits::kCoordinate)));
            break;
        }
        stroke.points.push_back(*point);
    }
    return stroke;
}

QJsonObject lassoToJson(const LassoStroke& stroke)
{
    QJsonObject json;
    for (const auto& [key, vector] : kPlane)
        json[key] = toJson(stroke.*vector);
    QJsonArray points;
    for (const Vec2& point : stroke.points)
        points.append(toJson(point));
    json[kPointsKey] = points;
    return json;
}

std::optional<int> readSteps(JsonReader& reader)
{
    if (!reader.has(kLassoStepsKey))
        return {};
    return static_cast<int>(reader.integer(kLassoStepsKey, 0, kMostEnvelopeSteps));
}

void writeSteps(QJsonObject& json, std::optional<int> steps)
{
    if (steps)
        json[kLassoStepsKey] = *steps;
}

LassoStroke recordableLasso(LassoStroke stroke)
{
    for (const auto& [key, vector] : kPlane)
        stroke.*vector = withoutNegativeZeros(stroke.*vector);
    for (Vec2& point : stroke.points)
        point = withoutNegativeZeros(point);
    return stroke;
}

} // namespace espalier

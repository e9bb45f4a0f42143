// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/LassoOperation.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kPointsKey("points");

struct PlaneVector {
    QLatin1StringView key;
    Vec3 LassoStroke::*vector;
};
constexpr PlaneVector kPlane[] = {{QLatin1StringView("origin"), &LassoStroke::origin},
                                  {QLatin1StringView("right"), &LassoStroke::right},
                                  {QLatin1StringView("up"), &LassoStroke::up}};

} // namespace

LassoOperation LassoOperation::read(JsonReader& reader, RecipeReading& reading)
{
    LassoOperation lasso;
    lasso.only = BudReference::read(reader);
    for (const auto& [key, vector] : kPlane) {
        if (!reader.has(key))
            continue;
        if (const auto read = vectorFromJson<3>(reader.array(key), recipeLimits::kCoordinate))
            lasso.stroke.*vector = *read;
        else
            reader.fail(
                key, RecipeText::tr("three numbers within ±%1 are expected").arg(recipeLimits::kCoordinate));
    }
    if (!isLasso(lasso.stroke))
        reader.fail(QLatin1StringView("up"),
                    RecipeText::tr("right and up must have length 1 and be at right angles"));

    const QJsonArray array = reader.array(kPointsKey);
    if (array.size() < kLeastPoints)
        reader.fail(kPointsKey, RecipeText::tr("a lasso has at least three points"));
    if (!reading.admitSamples(reader, kPointsKey, array.size()))
        return lasso;
    lasso.stroke.points.reserve(static_cast<std::size_t>(array.size()));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const auto point = vectorFromJson<2>(array.at(i).toArray(), recipeLimits::kCoordinate);
        if (!point) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kPointsKey)).arg(i),
                                   RecipeText::tr("two numbers within ±%1 are expected, right and up, in m")
                                       .arg(recipeLimits::kCoordinate)));
            break;
        }
        lasso.stroke.points.push_back(*point);
    }
    return lasso;
}

QJsonObject LassoOperation::write(RecipeWriting&) const
{
    QJsonObject json;
    for (const auto& [key, vector] : kPlane)
        json[key] = toJson(stroke.*vector);
    QJsonArray points;
    for (const Vec2& point : stroke.points)
        points.append(toJson(point));
    json[kPointsKey] = points;
    only.write(json);
    return json;
}

std::unique_ptr<Performance> LassoOperation::begin(TreeDocument& document) const
{
    const BudReference::Found found = only.resolve(document);
    return performanceOf(LassoGesture::fill(document, stroke, found.competitors), found.warning);
}

Box3 LassoOperation::reach() const
{
    Box3 box;
    box.extend(Vec3(Vec3::Zero()));
    for (const Vec2& point : stroke.points)
        box.extend(Vec3(stroke.origin + point.x() * stroke.right + point.y() * stroke.up));
    return box;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SweptTwigs.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kSweepsKey("sweeps");
constexpr QLatin1StringView kEyeKey("eye");
constexpr QLatin1StringView kSweepPathKey("path");
constexpr QLatin1StringView kThickestKey("thickest");
constexpr QLatin1StringView kNearSideKey("nearSide");

QString coordinatesExpected()
{
    return RecipeText::tr("three numbers within ±%1 are expected: x, y, z, in m")
        .arg(recipeLimits::kCoordinate);
}

std::optional<SweepPoint> sweepPointFrom(const QJsonArray& array)
{
    if (array.size() != 4)
        return std::nullopt;
    const auto position =
        vectorFromJson<3>({array.at(0), array.at(1), array.at(2)}, recipeLimits::kCoordinate);
    const double radius = array.at(3).toDouble(-1.0);
    if (!position || !(radius >= 0.0 && radius <= SweptTwigs::kGreatestRadius))
        return std::nullopt;
    return SweepPoint{*position, static_cast<float>(radius)};
}

Sweep readSweep(JsonReader& reader, RecipeReading& reading)
{
    Sweep sweep;
    if (const auto eye = vectorFromJson<3>(reader.array(kEyeKey), recipeLimits::kCoordinate))
        sweep.eye = *eye;
    else
        reader.fail(kEyeKey, coordinatesExpected());
    const QJsonArray path = reader.array(kSweepPathKey);
    if (path.isEmpty())
        reader.fail(kSweepPathKey, RecipeText::tr("a stroke needs at least one point"));
    if (!reading.admitSamples(reader, kSweepPathKey, path.size()))
        return sweep;
    for (qsizetype i = 0; i < path.size(); ++i) {
        const std::optional<SweepPoint> point = sweepPointFrom(path.at(i).toArray());
        if (!point) {
            reader.fail(inputError(
                QStringLiteral("%1[%2]").arg(reader.placeOf(kSweepPathKey)).arg(i),
                RecipeText::tr("four numbers are expected: x, y, z within ±%1 m, and a radius within 0…%2 m")
                    .arg(recipeLimits::kCoordinate)
                    .arg(SweptTwigs::kGreatestRadius)));
            break;
        }
        sweep.path.push_back(*point);
    }
    return sweep;
}

} // namespace

SweptTwigs SweptTwigs::read(JsonReader& reader, RecipeReading& reading)
{
    SweptTwigs twigs;
    twigs.thickest = reader.number(kThickestKey, 0.0, 1.0, kThickest);
    if (reader.integer(kNearSideKey, 0, 1, 0) == 1)
        twigs.depth = SweepDepth::NearSide;
    const QJsonArray sweeps = reader.array(kSweepsKey);
    if (sweeps.isEmpty())
        reader.fail(kSweepsKey, RecipeText::tr("one stroke or more is expected"));
    for (qsizetype i = 0; i < sweeps.size(); ++i) {
        JsonReader inner(sweeps.at(i).toObject(),
                         QStringLiteral("%1[%2]").arg(reader.placeOf(kSweepsKey)).arg(i));
        twigs.sweeps.push_back(readSweep(inner, reading));
        if (const Result<void> end = inner.finish(); !end) {
            reader.fail(end.error());
            break;
        }
    }
    return twigs;
}

void SweptTwigs::write(QJsonObject& json) const
{
    QJsonArray array;
    for (const Sweep& sweep : sweeps) {
        QJsonArray path;
        for (const SweepPoint& point : sweep.path) {
            QJsonArray numbers = toJson(point.position);
            numbers.append(shortestDouble(point.radius));
            path.append(numbers);
        }
        array.append(QJsonObject{{kEyeKey, toJson(sweep.eye)}, {kSweepPathKey, path}});
    }
    json[kSweepsKey] = array;
    json[kThickestKey] = thickest;
    if (depth == SweepDepth::NearSide)
        json[kNearSideKey] = 1;
}

} // namespace espalier

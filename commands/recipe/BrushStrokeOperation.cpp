// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/BrushStrokeOperation.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

#include <array>
#include <cmath>

namespace espalier {

namespace {

constexpr QLatin1StringView kSamplesKey("samples");
constexpr QLatin1StringView kUntilKey("until");
constexpr QLatin1StringView kArrivesKey("arrives");
constexpr QLatin1StringView kAroundKey("around");
constexpr QLatin1StringView kCopiesKey("copies");
constexpr QLatin1StringView kSpreadKey("spread");

/// Reads @p value into @p sample; returns what is wrong with it, if anything.
std::optional<QString> readSample(const QJsonValue& value, double previousTime, BrushSample& sample)
{
    const QJsonArray array = value.toArray();
    std::array<double, 5> numbers{};
    bool good = array.size() == 5;
    for (qsizetype i = 0; good && i < 5; ++i) {
        good = array.at(i).isDouble();
        numbers[static_cast<std::size_t>(i)] = array.at(i).toDouble();
    }
    if (!good)
        return RecipeText::tr("an array of five numbers is expected: time, x, y, z, radius");
    const auto& [time, x, y, z, radius] = numbers;
    if (!(time >= 0.0 && time <= BrushStrokeOperation::kGreatestTime))
        return RecipeText::tr("the time is not within 0…%1 s").arg(BrushStrokeOperation::kGreatestTime);
    if (time <= previousTime)
        return RecipeText::tr("the time does not go forwards");
    for (const double coordinate : {x, y, z}) {
        if (!(std::abs(coordinate) <= recipeLimits::kCoordinate))
            return RecipeText::tr("a coordinate is not within ±%1 m").arg(recipeLimits::kCoordinate);
    }
    if (!(radius >= 0.0 && radius <= BrushStrokeOperation::kGreatestRadius))
        return RecipeText::tr("the radius is not within 0…%1 m").arg(BrushStrokeOperation::kGreatestRadius);
    sample = {time, Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)),
              static_cast<float>(radius)};
    return {};
}

StrokePlacement readPlacement(JsonReader& reader)
{
    StrokePlacement placement;
    placement.copies = static_cast<int>(reader.integer(kCopiesKey, 1, StrokePlacement::kMostCopies, 1));
    placement.isSpread = reader.integer(kSpreadKey, 0, 1, 0) == 1;
    if (reader.has(kAroundKey)) {
        if (const auto around = vectorFromJson<3>(reader.array(kAroundKey), recipeLimits::kCoordinate))
            placement.around = *around;
        else
            reader.fail(kAroundKey, RecipeText::tr("three numbers within ±%1 are expected: x, y, z, in m")
                                        .arg(recipeLimits::kCoordinate));
    }
    return placement;
}

} // namespace

BrushStrokeOperation BrushStrokeOperation::read(JsonReader& reader, RecipeReading& reading)
{
    const QJsonArray array = reader.array(kSamplesKey);
    BrushStrokeOperation stroke;
    stroke.only = BudReference::read(reader);
    if (reader.has(kUntilKey))
        stroke.until = reader.number(kUntilKey, 0.0, kGreatestTime);
    if (reader.integer(kArrivesKey, 0, 1, 0) == 1)
        stroke.end = StrokeEnd::Arrives;
    stroke.placement = readPlacement(reader);
    if (array.isEmpty())
        reader.fail(kSamplesKey, RecipeText::tr("a stroke needs at least one sample"));
    if (!reading.admitSamples(reader, kSamplesKey, array.size()))
        return stroke;
    stroke.samples.resize(static_cast<std::size_t>(array.size()));
    double time = -1.0;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        if (const auto fault = readSample(array.at(static_cast<qsizetype>(i)), time, stroke.samples[i])) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kSamplesKey)).arg(i), *fault));
            break;
        }
        time = stroke.samples[i].time;
    }
    return stroke;
}

QJsonObject BrushStrokeOperation::write(RecipeWriting&) const
{
    QJsonArray array;
    for (const BrushSample& sample : samples) {
        array.append(QJsonArray{sample.time, shortestDouble(sample.position.x()),
                                shortestDouble(sample.position.y()), shortestDouble(sample.position.z()),
                                shortestDouble(sample.radius)});
    }
    QJsonObject json{{kSamplesKey, array}};
    only.write(json);
    if (until)
        json[kUntilKey] = *until;
    if (end == StrokeEnd::Arrives)
        json[kArrivesKey] = 1;
    if (placement.isUsual())
        return json;
    json[kAroundKey] = toJson(placement.around);
    if (placement.copies > 1)
        json[kCopiesKey] = placement.copies;
    if (placement.isSpread)
        json[kSpreadKey] = 1;
    return json;
}

Box3 BrushStrokeOperation::reach() const
{
    Box3 box;
    for (const BrushSample& sample : samples) {
        const Vec3 radius = Vec3::Constant(sample.radius);
        box.extend(Box3(sample.position - radius, sample.position + radius));
        if (placement.isUsual())
            continue;
        const Vec3 way = sample.position - placement.around;
        const float level = std::hypot(way.x(), way.z()) + sample.radius;
        for (const float side : {-level, level})
            box.extend(Vec3(placement.around + Vec3(side, way.y(), side)));
    }
    return box;
}

} // namespace espalier

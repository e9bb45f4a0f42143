// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SketchOperation.h"

#include "commands/recipe/DepthJson.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kStrokesKey("strokes");

/// The points of one stroke; @p reader gets the errors.
std::vector<Vec2> readStroke(JsonReader& reader, RecipeReading& reading, const QJsonArray& array,
                             qsizetype index)
{
    const QString place = QStringLiteral("%1[%2]").arg(reader.placeOf(kStrokesKey)).arg(index);
    std::vector<Vec2> stroke;
    if (array.isEmpty())
        reader.fail(inputError(place, RecipeText::tr("a stroke has at least one point")));
    if (!reading.admitSamples(reader, kStrokesKey, array.size()))
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

} // namespace

SketchOperation SketchOperation::read(JsonReader& reader, RecipeReading& reading)
{
    SketchOperation operation;
    TreeSketch& sketch = operation.sketch;
    sketch.depth = readDepth(reader);
    const QJsonArray strokes = reader.array(kStrokesKey);
    if (strokes.isEmpty() || static_cast<std::size_t>(strokes.size()) > kMostSketchStrokes) {
        reader.fail(kStrokesKey, RecipeText::tr("1 to %1 strokes are expected").arg(kMostSketchStrokes));
        return operation;
    }
    for (qsizetype i = 0; i < strokes.size(); ++i)
        sketch.strokes.push_back(readStroke(reader, reading, strokes.at(i).toArray(), i));
    return operation;
}

QJsonObject SketchOperation::write(RecipeWriting&) const
{
    QJsonArray strokes;
    for (const std::vector<Vec2>& stroke : sketch.strokes) {
        QJsonArray points;
        for (const Vec2& point : stroke)
            points.append(toJson(point));
        strokes.append(points);
    }
    QJsonObject json{{kStrokesKey, strokes}};
    writeDepth(json, sketch.depth);
    return json;
}

} // namespace espalier

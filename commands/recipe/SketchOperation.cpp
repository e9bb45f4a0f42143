// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SketchOperation.h"

#include "commands/recipe/DepthJson.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/StrokeJson.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kStrokesKey("strokes");

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
        sketch.strokes.push_back(readStroke(reader, reading, kStrokesKey,
                                            QStringLiteral("%1[%2]").arg(reader.placeOf(kStrokesKey)).arg(i),
                                            strokes.at(i).toArray()));
    return operation;
}

QJsonObject SketchOperation::write(RecipeWriting&) const
{
    QJsonArray strokes;
    for (const std::vector<Vec2>& stroke : sketch.strokes)
        strokes.append(strokeToJson(stroke));
    QJsonObject json{{kStrokesKey, strokes}};
    writeDepth(json, sketch.depth);
    return json;
}

} // namespace espalier

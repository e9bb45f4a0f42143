// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SketchOperation.h"

#include "commands/recipe/RecipeText.h"
#include "commands/recipe/StrokeJson.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kStrokesKey("strokes");
constexpr QLatin1StringView kSketchSeedKey("seed");
constexpr QLatin1StringView kTreesKey("trees");
constexpr QLatin1StringView kSidewaysKey("sideways");

struct SidewaysName {
    QLatin1StringView name;
    DepthOptions::Sideways sideways;
};
constexpr SidewaysName kSideways[] = {
    {QLatin1StringView("all"), DepthOptions::Sideways::All},
    {QLatin1StringView("limbs"), DepthOptions::Sideways::FirstOrder},
    {QLatin1StringView("none"), DepthOptions::Sideways::None},
};

} // namespace

SketchOperation SketchOperation::read(JsonReader& reader, RecipeReading& reading)
{
    SketchOperation operation;
    TreeSketch& sketch = operation.sketch;
    sketch.seed = reader.seed(kSketchSeedKey, 1);
    sketch.secondTree = reader.integer(kTreesKey, 1, 2, 2) == 2;
    const QString sideways = reader.text(kSidewaysKey, QString(kSideways[0].name));
    const auto* const named = std::ranges::find(kSideways, sideways, &SidewaysName::name);
    if (named == std::end(kSideways))
        reader.fail(kSidewaysKey,
                    RecipeText::tr("one of these is expected: %1").arg(QStringLiteral("all, limbs, none")));
    else
        sketch.sideways = named->sideways;
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
    if (sketch.seed != 1)
        json[kSketchSeedKey] = seedToJson(sketch.seed);
    if (!sketch.secondTree)
        json[kTreesKey] = 1;
    const auto* const named = std::ranges::find(kSideways, sketch.sideways, &SidewaysName::sideways);
    if (named != std::begin(kSideways))
        json[kSidewaysKey] = QString(named->name);
    return json;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SketchStrokeOperation.h"

#include "commands/recipe/LassoJson.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr qsizetype kLeastStrokePoints = 2;
constexpr QLatin1StringView kOnKey("on");
constexpr QLatin1StringView kOnAlongKey("along");
constexpr QLatin1StringView kRadiiKey("radii");
constexpr QLatin1StringView kReplacesKey("replaces");
constexpr QLatin1StringView kMirrorKey("mirror");

} // namespace

SketchStrokeOperation SketchStrokeOperation::of(const TreeDocument& document, const BranchStroke& stroke)
{
    SketchStrokeOperation operation{
        .stroke = stroke.stroke, .radii = stroke.radii, .mirror = stroke.isMirrored};
    if (stroke.base) {
        operation.on = InternodeReference::to(document, stroke.base->internode);
        operation.along = stroke.base->along;
    }
    if (stroke.replaces)
        operation.replaces = InternodeReference::to(document, *stroke.replaces);
    return operation;
}

SketchStrokeOperation SketchStrokeOperation::read(JsonReader& reader, RecipeReading& reading)
{
    SketchStrokeOperation operation{.stroke = readLasso(reader, reading, kLeastStrokePoints)};
    if (reader.has(kOnKey)) {
        operation.on = InternodeReference::read(reader, kOnKey);
        operation.along = static_cast<float>(reader.number(kOnAlongKey, 0.0, 1.0, 1.0));
    }
    if (reader.has(kReplacesKey))
        operation.replaces = InternodeReference::read(reader, kReplacesKey);
    operation.mirror = reader.integer(kMirrorKey, 0, 1, 0) == 1;
    if (!reader.has(kRadiiKey))
        return operation;
    const QJsonArray radii = reader.array(kRadiiKey);
    if (radii.size() > kMostRadii)
        reader.fail(kRadiiKey, RecipeText::tr("at most %1 radii are expected").arg(kMostRadii));
    for (const QJsonValue radius : radii) {
        if (!(radius.toDouble(-1.0) >= 0.0 && radius.toDouble() <= double{kGreatestDiameter}))
            reader.fail(kRadiiKey, RecipeText::tr("numbers from 0 to %1 are expected, in m")
                                       .arg(static_cast<double>(kGreatestDiameter)));
        operation.radii.push_back(static_cast<float>(radius.toDouble()));
    }
    return operation;
}

QJsonObject SketchStrokeOperation::write(RecipeWriting&) const
{
    QJsonObject json = lassoToJson(stroke);
    if (on) {
        json[kOnKey] = on->toJson();
        json[kOnAlongKey] = shortestDouble(along);
    }
    if (replaces)
        json[kReplacesKey] = replaces->toJson();
    if (mirror)
        json[kMirrorKey] = 1;
    if (!radii.empty()) {
        QJsonArray array;
        for (const float radius : radii)
            array.append(shortestDouble(radius));
        json[kRadiiKey] = array;
    }
    return json;
}

} // namespace espalier

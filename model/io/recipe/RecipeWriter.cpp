// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/JsonReader.h"
#include "model/io/ParametersJson.h"
#include "model/io/recipe/Recipe.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <charconv>

namespace espalier {

namespace {

/// As few digits as lead back to the same number.
template <class T>
void appendNumber(QByteArray& text, T number)
{
    char digits[40];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr - digits);
}

QByteArray compact(const QJsonObject& json)
{
    return QJsonDocument(json).toJson(QJsonDocument::Compact);
}

QByteArray compact(const QString& text)
{
    const QByteArray array = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return array.mid(1, array.size() - 2);
}

QString nameOfImage(const ImageAsset& image)
{
    return image.name();
}

/// What differs from @p base, and what an image would bring along if it were not said.
QJsonObject changes(const TreeParameters& parameters, const TreeParameters& base)
{
    QJsonObject json = toJson(parameters, base, nameOfImage);
    const QLatin1StringView key("leaves");
    QJsonObject leaves = json.value(key).toObject();
    if (!leaves.value(QLatin1StringView("image")).toString().isEmpty()) {
        const QJsonObject all = toJson(parameters).value(key).toObject();
        for (const char* name : {"aspect", "hue", "saturation", "brightness"})
            leaves[QLatin1StringView(name)] = all[QLatin1StringView(name)];
        json[key] = leaves;
    }
    return json;
}

/// Writes the operations in turn; parameters only as far as they change.
struct OperationWriter {
    QByteArray& text;
    TreeParameters parameters; ///< In force

    void operator()(const SetParametersOperation& operation)
    {
        text += R"({"op":"setParameters","parameters":)" +
                compact(changes(operation.parameters, parameters)) + '}';
        parameters = operation.parameters;
    }
    void operator()(const BrushStrokeOperation& operation) const
    {
        text += R"({"op":"brushStroke","samples":[)";
        for (const BrushSample& sample : operation.samples) {
            text += &sample == operation.samples.data() ? "\n      [" : ",\n      [";
            appendNumber(text, sample.time);
            for (const float number :
                 {sample.position.x(), sample.position.y(), sample.position.z(), sample.radius}) {
                text += ',';
                appendNumber(text, number);
            }
            text += ']';
        }
        text += "\n    ]" + only(operation.competitors) + '}';
    }
    void operator()(const GrowOperation& operation) const
    {
        text += R"({"op":"grow","steps":)" + QByteArray::number(operation.steps) +
                only(operation.competitors) + '}';
    }
    void operator()(const PruneOperation& operation) const
    {
        text += R"({"op":"prune","internodes":[)";
        for (const InternodeId& id : operation.internodes)
            text += (&id == operation.internodes.data() ? "" : ",") + QByteArray::number(id);
        text += "]}";
    }
    void operator()(const LassoOperation& operation) const
    {
        text += R"({"op":"lasso")";
        const LassoStroke& stroke = operation.stroke;
        write("origin", stroke.origin);
        write("right", stroke.right);
        write("up", stroke.up);
        text += R"(,"points":[)";
        for (const Vec2& point : stroke.points) {
            text += &point == stroke.points.data() ? "\n      [" : ",\n      [";
            appendNumber(text, point.x());
            text += ',';
            appendNumber(text, point.y());
            text += ']';
        }
        text += "\n    ]" + only(operation.competitors) + '}';
    }
    void operator()(const RegrowOperation&) const { text += R"({"op":"regrow"})"; }
    void operator()(const RemoveLassoOperation&) const { text += R"({"op":"removeLasso"})"; }
    void operator()(const TravelOperation& operation) const { write("travel", "by", operation.by); }
    void operator()(const BendOperation& operation) const
    {
        text += R"({"op":"bend","base":)" + QByteArray::number(operation.base) + R"(,"handles":[)";
        for (const BendOperation::Handle& handle : operation.handles) {
            text += &handle == operation.handles.data() ? R"({"internode":)" : R"(,{"internode":)";
            text += QByteArray::number(handle.internode) + R"(,"along":)";
            appendNumber(text, handle.along);
            text += R"(,"target":[)";
            for (int i = 0; i < 3; ++i) {
                text += i == 0 ? "" : ",";
                appendNumber(text, handle.target[i]);
            }
            text += "]}";
        }
        text += R"(],"bending":)";
        appendNumber(text, operation.bending);
        text += R"(,"stretching":)";
        appendNumber(text, operation.stretching);
        text += '}';
    }
    void operator()(const SetWidthOperation& operation) const
    {
        text +=
            R"({"op":"setWidth","internode":)" + QByteArray::number(operation.internode) + R"(,"diameter":)";
        appendNumber(text, operation.diameter);
        text += '}';
    }
    void operator()(const UndoOperation& operation) const { write("undo", "count", operation.count); }
    void operator()(const RedoOperation& operation) const { write("redo", "count", operation.count); }

    void write(const char* key, const Vec3& vector) const
    {
        text += ",\"" + QByteArray(key) + "\":[";
        for (int i = 0; i < 3; ++i) {
            text += i == 0 ? "" : ",";
            appendNumber(text, vector[i]);
        }
        text += ']';
    }
    static QByteArray only(const Competitors& competitors)
    {
        return competitors.areAll() ? QByteArray()
                                    : R"(,"only":{"internode":)" + QByteArray::number(competitors.node) +
                                          R"(,"bud":)" + QByteArray::number(competitors.slot) + '}';
    }
    void write(const char* op, const char* key, int number) const
    {
        text += R"({"op":")" + QByteArray(op) + R"(",")" + key + R"(":)" + QByteArray::number(number) + '}';
    }
};

} // namespace

QByteArray writeRecipe(const Recipe& recipe)
{
    QByteArray text = "{\n  \"" + QByteArray(recipeLimits::kVersionKey.data()) +
                      "\": " + QByteArray::number(recipeLimits::kVersion);
    text += ",\n  \"name\": " + compact(recipe.name);
    text += ",\n  \"description\": " + compact(recipe.description);
    const QByteArray seed = compact(QJsonObject{{QStringLiteral("seed"), seedToJson(recipe.seed)}});
    text += ",\n  \"seed\": " + seed.mid(8, seed.size() - 9);
    text += ",\n  \"parameters\": " + compact(toJson(recipe.parameters, nameOfImage));
    if (!recipe.camera.view.isEmpty())
        text += ",\n  \"camera\": {\"view\":" + compact(recipe.camera.view) + '}';
    text += ",\n  \"operations\": [";
    OperationWriter writer{text, recipe.parameters};
    for (const RecipeOperation& operation : recipe.operations) {
        text += &operation == recipe.operations.data() ? "\n    " : ",\n    ";
        std::visit(writer, operation);
    }
    text += recipe.operations.empty() ? "]\n}\n" : "\n  ]\n}\n";
    return text;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/Recipe.h"

#include "commands/recipe/ImportOperation.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"
#include "model/io/FileReader.h"
#include "model/io/ParametersJson.h"

#include <QFileInfo>
#include <QJsonDocument>

namespace espalier {

namespace {

constexpr QLatin1StringView kNameKey("name");
constexpr QLatin1StringView kDescriptionKey("description");
constexpr QLatin1StringView kSeedKey("seed");
constexpr QLatin1StringView kFirstParametersKey("parameters");
constexpr QLatin1StringView kCameraKey("camera");
constexpr QLatin1StringView kViewKey("view");
constexpr QLatin1StringView kOperationsKey("operations");
constexpr QLatin1StringView kViews[] = {QLatin1StringView("front"), QLatin1StringView("side"),
                                        QLatin1StringView("top"), QLatin1StringView("three-quarter")};

RecipeCamera readCamera(JsonReader& parent)
{
    JsonReader reader(parent.object(kCameraKey), parent.placeOf(kCameraKey));
    RecipeCamera camera;
    camera.view = reader.text(kViewKey, QString());
    if (reader.has(kViewKey) && std::ranges::find(kViews, camera.view) == std::end(kViews)) {
        reader.fail(kViewKey,
                    RecipeText::tr("there is no view “%1”; there are front, side, top and three-quarter")
                        .arg(camera.view));
    }
    if (const Result<void> end = reader.finish(); !end)
        parent.fail(end.error());
    return camera;
}

} // namespace

Result<Recipe> parseRecipe(const QByteArray& json, const QString& folder)
{
    const Result<QJsonObject> parsed = parseJsonObject(json, recipeLimits::kBytes);
    if (!parsed)
        return parsed.error();
    JsonReader reader(*parsed, {});
    if (!reader.has(recipeLimits::kVersionKey)) {
        return inputError({}, RecipeText::tr("this is not a recipe: a recipe begins with “%1”: %2")
                                  .arg(QString(recipeLimits::kVersionKey))
                                  .arg(recipeLimits::kVersion));
    }
    const auto version =
        reader.integer(recipeLimits::kVersionKey, 1, std::numeric_limits<std::int32_t>::max());
    if (version > recipeLimits::kVersion) {
        return inputError({},
                          RecipeText::tr("the recipe is of version %1; this program reads versions up to %2")
                              .arg(version)
                              .arg(recipeLimits::kVersion));
    }
    Recipe recipe;
    recipe.name = reader.text(kNameKey, QString());
    recipe.description = reader.text(kDescriptionKey, QString());
    recipe.seed = reader.seed(kSeedKey, 1);
    RecipeReading reading(folder);
    if (version == 1)
        reading.setParameters(parametersOfFirstFiles());
    if (const Result<void> read =
            reading.readParameters(reader.object(kFirstParametersKey), QString(kFirstParametersKey));
        !read)
        reader.fail(read.error());
    recipe.parameters = reading.parameters();
    recipe.camera = readCamera(reader);
    const QJsonArray operations = reader.array(kOperationsKey);
    if (operations.size() > recipeLimits::kOperations) {
        reader.fail(kOperationsKey,
                    RecipeText::tr("a recipe can have at most %1 operations").arg(recipeLimits::kOperations));
    }
    if (const Result<void> end = reader.finish(); !end)
        return end.error();

    recipe.operations.reserve(static_cast<std::size_t>(operations.size()));
    for (qsizetype i = 0; i < operations.size(); ++i) {
        Result<RecipeOperation> operation =
            readOperation(operations.at(i), QStringLiteral("operations[%1]").arg(i), reading);
        if (!operation)
            return operation.error();
        recipe.operations.push_back(std::move(*operation));
    }
    return recipe;
}

Result<Recipe> readRecipe(const QString& fileName)
{
    const QString name = QFileInfo(fileName).fileName();
    if (QFileInfo(fileName).suffix().toLower() == kSkeletonSuffix) {
        Result<Skeleton> skeleton = readSkeletonFile(fileName);
        if (!skeleton)
            return skeleton.error();
        Recipe recipe;
        recipe.name = QFileInfo(fileName).completeBaseName();
        recipe.operations = {ImportOperation{std::move(*skeleton)}};
        return recipe;
    }
    const Result<QByteArray> bytes = readFile(fileName, recipeLimits::kBytes, FileKind::Any);
    if (!bytes)
        return bytes.error();
    Result<Recipe> recipe = parseRecipe(*bytes, QFileInfo(fileName).path());
    if (!recipe)
        return inputError(name, recipe.error().message);
    return recipe;
}

QByteArray writeRecipe(const Recipe& recipe)
{
    RecipeWriting writing{recipe.parameters};
    QJsonArray operations;
    for (const RecipeOperation& operation : recipe.operations)
        operations.append(operation.write(writing));
    QJsonObject json{{recipeLimits::kVersionKey, recipeLimits::kVersion},
                     {kNameKey, recipe.name},
                     {kDescriptionKey, recipe.description},
                     {kSeedKey, seedToJson(recipe.seed)},
                     {kFirstParametersKey, toJson(recipe.parameters, &ImageAsset::name)},
                     {kOperationsKey, operations}};
    if (!recipe.camera.view.isEmpty())
        json[kCameraKey] = QJsonObject{{kViewKey, recipe.camera.view}};
    const QJsonDocument document(json);
    QByteArray text = document.toJson(QJsonDocument::Compact);
    if (text.size() <= recipeLimits::kIndentedBytes)
        text = document.toJson(QJsonDocument::Indented);
    return text;
}

} // namespace espalier

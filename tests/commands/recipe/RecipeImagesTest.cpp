// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/commands/recipe/RecipeTexts.h"
#include "tests/support/AllOperations.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace espalier::test {

class RecipeImagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void images_areFilesBesideTheRecipe();
    void images_bringTheirLookUnlessItIsSaid();
    void wrongImages_areRefused_data();
    void wrongImages_areRefused();
};

namespace {

/// A folder with oak/leaf.png, oak/bark.png and noise.png, and room for a recipe in oak.
struct RecipeFolder {
    RecipeFolder()
    {
        QDir(folder.path()).mkdir(QStringLiteral("oak"));
        write(QStringLiteral("oak/leaf.png"), pngOf(drawnLeaf(Qt::transparent)));
        write(QStringLiteral("oak/bark.png"), pngOf(repeatingBark(64, 64)));
        QImage noise = repeatingBark(64, 64);
        noise.setPixelColor(3, 3, Qt::red);
        write(QStringLiteral("noise.png"), pngOf(noise));
    }
    void write(const QString& name, const QByteArray& content) const
    {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    Result<Recipe> read(const QByteArray& body) const
    {
        write(QStringLiteral("oak/recipe.json"), recipeOf(body));
        return readRecipe(folder.filePath(QStringLiteral("oak/recipe.json")));
    }

    QTemporaryDir folder;
};

} // namespace

void RecipeImagesTest::images_areFilesBesideTheRecipe()
{
    const RecipeFolder folder;
    const Result<Recipe> result = folder.read(R"("parameters": {"leaves": {"image": "leaf.png"},
        "bark": {"image": "bark.png", "roughnessImage": "../noise.png"}}, "operations": [
        {"op": "setParameters", "parameters": {"leaves": {"length": 0.2}}},
        {"op": "setParameters", "parameters": {"bark": {"image": ""}}},
        {"op": "setParameters", "parameters": {"bark": {"normalImage": "./bark.png"}}}])");
    QVERIFY2(result, result ? "" : qPrintable(result.error().message));
    QCOMPARE(result->parameters.leaves.image.file(), pngOf(drawnLeaf(Qt::transparent)));
    QCOMPARE(result->parameters.leaves.image.name(), QStringLiteral("leaf.png"));
    QCOMPARE(result->parameters.bark.roughnessImage.name(), QStringLiteral("../noise.png"));
    QVERIFY(result->parameters.bark.normalImage.isNull());
    const auto parametersOf = [&](std::size_t i) {
        return result->operations[i].as<SetParametersOperation>()->parameters;
    };
    QVERIFY(parametersOf(0).leaves.image == result->parameters.leaves.image);
    QVERIFY(parametersOf(1).bark.image.isNull());
    QVERIFY(!parametersOf(1).bark.roughnessImage.isNull());
    QVERIFY(parametersOf(2).bark.normalImage == result->parameters.bark.image);
    // Written to the same folder, it reads back the same.
    const QByteArray json = writeRecipe(*result);
    const Result<Recipe> back = parseRecipe(json, folder.folder.filePath(QStringLiteral("oak")));
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(*back == *result);
    QCOMPARE(writeRecipe(*back), json);
}

void RecipeImagesTest::images_bringTheirLookUnlessItIsSaid()
{
    const RecipeFolder folder;
    const Result<Recipe> result = folder.read(
        R"("parameters": {"leaves": {"image": "leaf.png", "hue": 20, "saturation": 0.5}}, "operations": [
        {"op": "setParameters", "parameters": {"leaves": {"image": "leaf.png", "aspect": 1.5}}},
        {"op": "setParameters", "parameters": {"leaves": {"image": ""}}},
        {"op": "setParameters", "parameters": {"leaves": {"image": "leaf.png"}}}])");
    QVERIFY2(result, result ? "" : qPrintable(result.error().message));
    const LeafParameters& leaves = result->parameters.leaves;
    QVERIFY(std::abs(leaves.aspect - 0.5) < 0.03);
    QCOMPARE(leaves.hue, radians(20));
    QCOMPARE(leaves.saturation, 0.5);
    QCOMPARE(leaves.brightness, 1.0);
    const auto leavesOf = [&](std::size_t i) {
        return result->operations[i].as<SetParametersOperation>()->parameters.leaves;
    };
    QCOMPARE(leavesOf(0).aspect, 1.5);
    QCOMPARE(leavesOf(0).hue, radians(20)); // the same image again changes nothing
    QCOMPARE(leavesOf(1).hue, radians(20));
    QCOMPARE(leavesOf(2).hue, radians(98));
    QVERIFY(std::abs(leavesOf(2).aspect - 0.5) < 0.03);
    const Result<Recipe> back =
        parseRecipe(writeRecipe(*result), folder.folder.filePath(QStringLiteral("oak")));
    QVERIFY(back && *back == *result);
}

void RecipeImagesTest::wrongImages_areRefused_data()
{
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* title, const char* group, const char* value, const char* message) {
        QTest::newRow(title) << QByteArray("\"parameters\": {\"") + group + "\": {\"image\": " + value + "}}"
                             << QStringLiteral("recipe.json: parameters.") + QLatin1String(group) +
                                    QStringLiteral(".image: ") + QString::fromUtf8(message);
    };
    row("number", "leaves", "5", "the name of an image is expected");
    row("missing", "bark", "\"none.png\"", "none.png: there is no such file");
    row("absolute", "bark", "\"/etc/hostname\"", "/etc/hostname: a path relative to the recipe is expected");
    row("folder", "bark", "\"..\"", "..: it is a folder");
    row("no image", "bark", "\"recipe.json\"", "recipe.json: it is neither a PNG nor a JPEG image");
    row("no leaf", "leaves", "\"../noise.png\"",
        "../noise.png: the leaf cannot be told apart from its background");
}

void RecipeImagesTest::wrongImages_areRefused()
{
    QFETCH(const QByteArray, body);
    QFETCH(const QString, message);
    const Result<Recipe> result = RecipeFolder().read(body);
    QVERIFY(!result);
    QVERIFY2(result.error().message.startsWith(message), qPrintable(result.error().message));
    // Without a file there is no folder for the images.
    QVERIFY(!parseRecipe(recipeOf(body)));
}

static const TestClass<RecipeImagesTest> recipeImagesTest;

} // namespace espalier::test

#include "RecipeImagesTest.moc"

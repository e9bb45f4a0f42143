// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/recipe/Recipe.h"

#include "model/base/Random.h"
#include "model/io/JsonReader.h"
#include "model/io/ParametersJson.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

namespace espalier::test {

namespace {

QByteArray recipe(const QByteArray& members)
{
    return R"({"espalier-recipe": 1, )" + members + '}';
}

QByteArray operations(const QByteArray& list)
{
    return recipe("\"operations\": [" + list + ']');
}

/// Any recipe that parseRecipe may give.
Recipe randomRecipe(std::uint64_t seed)
{
    Random random(seed, 0, 0, Purpose::Direction);
    const auto randomParameters = [&] {
        TreeParameters parameters;
        visitParameters(parameters, [&](const ParameterInfo& info, auto& field) {
            using Field = std::remove_reference_t<decltype(field)>;
            const double value = random.uniform(info.minimum, info.maximum);
            if constexpr (std::is_same_v<Field, double>)
                field = info.quantity == Quantity::Angle ? radians(value) : value;
            else
                field = static_cast<Field>(static_cast<int>(std::lround(value)));
        });
        GrowthParameters& growth = parameters.growth;
        growth.ellipseOffset =
            std::clamp(growth.ellipseOffset, -0.9 * growth.ellipseVertical, growth.ellipseVertical / 2);
        normaliseDirectionWeights(growth);
        return parameters;
    };
    Recipe result;
    result.name = QStringLiteral("Ginkgo “%1” \\ \n").arg(seed);
    result.description = QStringLiteral("täglich \"gegossen\"");
    result.seed = random.bits();
    result.parameters = randomParameters();
    result.camera.view = QStringLiteral("three-quarter");
    for (int i = 0; i < 20; ++i) {
        BrushStrokeOperation stroke;
        for (double time = 0.0; time < 3.0; time += 0.01 + random.uniform()) {
            stroke.samples.push_back(
                {time, 100.0F * random.inBall(), static_cast<float>(random.uniform() * random.uniform())});
        }
        result.operations.emplace_back(stroke);
        result.operations.emplace_back(SetParametersOperation{randomParameters()});
        if (i % 3 == 0)
            stroke.competitors = {static_cast<InternodeId>(random.bits() % 1000), i % kMaxLaterals};
        result.operations.emplace_back(GrowOperation{i + 1, stroke.competitors});
        result.operations.emplace_back(PruneOperation{{7U, static_cast<InternodeId>(random.bits() % 1000)}});
        result.operations.emplace_back(TravelOperation{i - 50});
        result.operations.emplace_back(UndoOperation{i + 2});
        result.operations.emplace_back(RedoOperation{i + 3});
        BendOperation bend{.base = static_cast<InternodeId>(i),
                           .handles = {},
                           .bending = random.uniform(0.01, 100.0),
                           .stretching = random.uniform(0.01, 100.0)};
        for (int handle = 0; handle <= i; ++handle) {
            bend.handles.push_back(
                {static_cast<InternodeId>(i + 7 * handle), random.uniform(), 10.0F * random.inBall()});
        }
        result.operations.emplace_back(bend);
        result.operations.emplace_back(
            SetWidthOperation{0xffff'fffe - static_cast<InternodeId>(i), random.uniform(0.0, 100.0)});
        LassoOperation lasso;
        lasso.competitors = stroke.competitors;
        lasso.stroke.origin = 100.0F * random.inBall();
        lasso.stroke.right = random.direction();
        lasso.stroke.up = anyPerpendicular(lasso.stroke.right);
        for (int j = 0; j < 3 + i; ++j)
            lasso.stroke.points.push_back(10.0F * random.inBall().head<2>());
        result.operations.emplace_back(lasso);
        result.operations.emplace_back(RegrowOperation{});
        result.operations.emplace_back(RemoveLassoOperation{});
    }
    return result;
}

} // namespace

class RecipeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyOperation_isRead();
    void setParameters_buildsOnThoseBefore();
    void weights_areScaledToSumToOne();
    void writtenRecipe_readsBackTheSame_data();
    void writtenRecipe_readsBackTheSame();
    void writtenRecipe_isReadable();
    void parameters_roundTripToTheLastBit();
    void degrees_areWrittenShort();
    void images_areFilesBesideTheRecipe();
    void images_bringTheirLookUnlessItIsSaid();
    void wrongImages_areRefused_data();
    void wrongImages_areRefused();
    void seeds_areNumbersOrStrings();
    void wrongRecipes_nameThePlace_data();
    void wrongRecipes_nameThePlace();
    void wrongParameters_areAllRefusedJustBeyondTheirLimits();
    void hugeRecipes_areRefusedBeforeTheyAreParsed();
    void missingFile_saysSo();
    void schemaAndTable_agree();
    void schemaAndLimits_agree();
    void documentation_hasEveryParameterWithItsLimits();
    void documentation_examplesAreRecipes();
    void sampleRecipes_areRecipes();
};

void RecipeTest::everyOperation_isRead()
{
    const Result<Recipe> result = parseRecipe(recipe(R"(
        "name": "Oak", "description": "d", "seed": 5, "camera": {"view": "top"},
        "parameters": {"growth": {"phyllotaxis": 90}, "leaves": {"visible": false, "shape": "lobed"}, "bark": {"kind": "birch"}},
        "operations": [
            {"op": "brushStroke", "samples": [[0, 1, 2, 3, 0.5], [1.5, -1, 0, 0.1, 0]]},
            {"op": "grow", "steps": 7}, {"op": "prune", "internodes": [12, 3]},
            {"op": "grow", "steps": 2, "only": {"internode": 4, "bud": 1}}, {"op": "travel", "by": -5}, {"op": "undo", "count": 2}, {"op": "redo"},
            {"op": "setParameters", "parameters": {"widths": {"exponent": 3}}},
            {"op": "bend", "base": 2, "handles": [{"internode": 9, "along": 0.25, "target": [1, -2, 0.5]},
                {"internode": 5, "target": [0, 1, 0]}], "bending": 0.5, "stretching": 8},
            {"op": "setWidth", "internode": 4, "diameter": 0.125},
            {"op": "lasso", "origin": [1, 2, 3], "right": [0, 0, -1], "points": [[0, 1], [2, 3.5], [-1, 2]],
             "only": {"internode": 5}},
            {"op": "regrow"}, {"op": "removeLasso"}])"));
    QVERIFY2(result, result ? "" : qPrintable(result.error().message));
    QCOMPARE(result->name, QStringLiteral("Oak"));
    QCOMPARE(result->description, QStringLiteral("d"));
    QCOMPARE(result->seed, 5U);
    QCOMPARE(result->camera.view, QStringLiteral("top"));
    QCOMPARE(result->parameters.growth.phyllotaxis, std::numbers::pi / 2);
    QCOMPARE(result->parameters.leaves.visible, false);
    QVERIFY(result->parameters.leaves.shape == LeafShape::Lobed);
    QVERIFY(result->parameters.bark.kind == BarkKind::Birch);
    QCOMPARE(result->parameters.widths, WidthParameters());
    const BrushStrokeOperation stroke{{{0.0, Vec3(1, 2, 3), 0.5F}, {1.5, Vec3(-1, 0, 0.1F), 0.0F}}, {}};
    TreeParameters later = result->parameters;
    later.widths.exponent = 3;
    LassoOperation lasso;
    lasso.stroke.origin = Vec3(1, 2, 3);
    lasso.stroke.right = -Vec3::UnitZ();
    lasso.stroke.points = {{0, 1}, {2, 3.5F}, {-1, 2}};
    lasso.competitors = {5, kTerminalSlot};
    const std::vector<RecipeOperation> expected{
        stroke,
        GrowOperation{7},
        PruneOperation{{12, 3}},
        GrowOperation{2, {4, 1}},
        TravelOperation{-5},
        UndoOperation{2},
        RedoOperation{1},
        SetParametersOperation{later},
        BendOperation{.base = 2,
                      .handles = {{9, 0.25, Vec3(1, -2, 0.5F)}, {5, 1.0, Vec3(0, 1, 0)}},
                      .bending = 0.5,
                      .stretching = 8},
        SetWidthOperation{4, 0.125},
        lasso,
        RegrowOperation{},
        RemoveLassoOperation{}};
    QVERIFY(result->operations == expected);
}

void RecipeTest::setParameters_buildsOnThoseBefore()
{
    const Result<Recipe> result =
        parseRecipe(recipe(R"("parameters": {"growth": {"irregularity": 0.125}}, "operations": [
        {"op": "setParameters", "parameters": {"growth": {"shedding": 0.25}}},
        {"op": "setParameters", "parameters": {"growth": {"shedding": 0.75, "maxShootLength": 9}}}])"));
    QVERIFY(result);
    const auto& growth = std::get<SetParametersOperation>(result->operations[1]).parameters.growth;
    QCOMPARE(growth.irregularity, 0.125);
    QCOMPARE(growth.shedding, 0.75);
    QCOMPARE(growth.maxShootLength, 9);
}

void RecipeTest::weights_areScaledToSumToOne()
{
    const Result<Recipe> result = parseRecipe(recipe(
        R"("parameters": {"growth": {"axisWeight": 1, "tropismWeight": 0.25, "spaceWeight": 0.75}},
           "operations": [{"op": "setParameters", "parameters": {"growth": {"axisWeight": 0.5}}}])"));
    QVERIFY(result);
    QCOMPARE(result->parameters.growth.axisWeight, 0.5);
    QCOMPARE(result->parameters.growth.tropismWeight, 0.125);
    QCOMPARE(result->parameters.growth.spaceWeight, 0.375);
    // Weights that sum to 1 already keep their bits.
    const auto& later = std::get<SetParametersOperation>(result->operations[0]).parameters;
    QVERIFY(later == result->parameters);
}

void RecipeTest::writtenRecipe_readsBackTheSame_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 20; ++seed)
        QTest::addRow("%d", seed) << seed;
}

void RecipeTest::writtenRecipe_readsBackTheSame()
{
    QFETCH(int, seed);
    const Recipe original = randomRecipe(static_cast<std::uint64_t>(seed));
    const QByteArray json = writeRecipe(original);
    const Result<Recipe> back = parseRecipe(json);
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(*back == original);
    QCOMPARE(writeRecipe(*back), json);
}

void RecipeTest::writtenRecipe_isReadable()
{
    Recipe original;
    original.name = QStringLiteral("Elm");
    original.operations = {
        BrushStrokeOperation{{{0.1, Vec3(0.1F, -2, 0), 0.3F}, {0.2, Vec3(1e-7F, 3.25F, 1), 0}}},
        GrowOperation{3}};
    const QByteArray json = writeRecipe(original);
    QVERIFY(json.contains("{\"op\":\"brushStroke\",\"samples\":[\n      [0.1,0.1,-2,0,0.3],\n      "
                          "[0.2,1e-07,3.25,1,0]\n    ]}"));
    QVERIFY(json.contains("\n    {\"op\":\"grow\",\"steps\":3}\n"));
    QVERIFY(json.contains("\"seed\": 1,"));
}

void RecipeTest::parameters_roundTripToTheLastBit()
{
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const TreeParameters parameters = randomRecipe(seed).parameters;
        const Result<TreeParameters> back =
            fromJson(QJsonDocument::fromJson(QJsonDocument(toJson(parameters)).toJson()).object(), {},
                     QStringLiteral("p"));
        QVERIFY2(back, back ? "" : qPrintable(back.error().message));
        QVERIFY(*back == parameters);
        QVERIFY(toJson(parameters, parameters).isEmpty());
        const TreeParameters base = randomRecipe(seed + 1).parameters;
        QVERIFY(*fromJson(toJson(parameters, base), base, {}) == parameters);
    }
}

void RecipeTest::degrees_areWrittenShort()
{
    TreeParameters parameters;
    for (const double angle : {137.5, 0.1, 33.3, 59.9, 1e-9, 52.0}) {
        parameters.growth.phyllotaxis = radians(angle);
        QCOMPARE(toJson(parameters)[QLatin1String("growth")][QLatin1String("phyllotaxis")].toDouble(), angle);
    }
}

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
        write(QStringLiteral("oak/recipe.json"), recipe(body));
        return readRecipe(folder.filePath(QStringLiteral("oak/recipe.json")));
    }

    QTemporaryDir folder;
};

} // namespace

void RecipeTest::images_areFilesBesideTheRecipe()
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
        return std::get<SetParametersOperation>(result->operations[i]).parameters;
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

void RecipeTest::images_bringTheirLookUnlessItIsSaid()
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
        return std::get<SetParametersOperation>(result->operations[i]).parameters.leaves;
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

void RecipeTest::wrongImages_areRefused_data()
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
    row("folder", "bark", "\"..\"", "..: there is no such file");
    row("no image", "bark", "\"recipe.json\"", "recipe.json: it is neither a PNG nor a JPEG image");
    row("no leaf", "leaves", "\"../noise.png\"",
        "../noise.png: there is no telling the leaf from what is behind it");
}

void RecipeTest::wrongImages_areRefused()
{
    QFETCH(const QByteArray, body);
    QFETCH(const QString, message);
    const Result<Recipe> result = RecipeFolder().read(body);
    QVERIFY(!result);
    QVERIFY2(result.error().message.startsWith(message), qPrintable(result.error().message));
    // What is no file has no folder to look in.
    QVERIFY(!parseRecipe(recipe(body)));
}

void RecipeTest::seeds_areNumbersOrStrings()
{
    QCOMPARE(parseRecipe(recipe(R"("seed": 9007199254740992)"))->seed, 9007199254740992U);
    QCOMPARE(parseRecipe(recipe(R"("seed": "18446744073709551615")"))->seed, 18446744073709551615U);
    QCOMPARE(parseRecipe(recipe(R"("seed": "0012")"))->seed, 12U);
    QCOMPARE(parseRecipe(recipe(R"("name": "")"))->seed, 1U);
}

void RecipeTest::wrongRecipes_nameThePlace_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("message");
    const auto row = [](const QByteArray& json, const char* message) {
        QTest::newRow(message) << json << QString::fromUtf8(message);
    };
    row("", "line 1: not valid JSON: ");
    row("[1]", "a JSON object is expected");
    row("{}", "this is no recipe");
    row("{\"espalier-recipe\": 1,\n\n \"name\": nan}", "line 3: not valid JSON: ");
    row("{\"espalier-recipe\": 1, \"seed\": 1e999}", "line 1: not valid JSON: illegal number");
    row(R"({"espalier-recipe": 2, "new": 1})",
        "the recipe is of version 2, this program reads versions up to 1");
    row(R"({"espalier-recipe": "1"})", "espalier-recipe: a whole number");
    row(recipe(R"("nmae": "x")"), "“nmae” is not known here");
    row(recipe(R"("name": 5)"), "name: a string is expected");
    row(recipe(R"("seed": -1)"), "seed: a whole number of at most 64 bits");
    row(recipe(R"("seed": 1.5)"), "seed: a whole number of at most 64 bits is");
    row(recipe(R"("seed": "18446744073709551616")"), "seed: a whole number of at most 64 bits is expected");
    row(recipe(R"("seed": "1x")"), "seed: a whole number of at most 64 bits is expected,");
    row(recipe(R"("camera": {"view": "below"})"), "camera.view: there is no view “below”");
    row(recipe(R"("camera": {"zoom": 2})"), "camera: “zoom” is not known here");
    row(recipe(R"("camera": 5)"), "camera: an object is expected");
    row(recipe(R"("operations": {})"), "operations: an array is expected");
    row(operations("5"), "operations[0]: an object is expected");
    row(operations("{}"), "operations[0].op: it is missing");
    row(operations(R"({"op": "grow", "steps": 1}, {"op": "mow"})"),
        "operations[1].op: there is no operation “mow”");
    row(operations(R"({"op": "grow"})"), "operations[0].steps: it is missing");
    row(operations(R"({"op": "grow", "steps": 0})"), "operations[0].steps: a whole number from 1 to 10000");
    row(operations(R"({"op": "grow", "steps": 10001})"),
        "operations[0].steps: a whole number from 1 to 10000 ");
    row(operations(R"({"op": "grow", "steps": "5"})"),
        "operations[0].steps: a whole number from 1 to 10000 is");
    row(operations(R"({"op": "grow", "steps": 2.5})"),
        "operations[0].steps: a whole number from 1 to 10000 is expected");
    row(operations(R"({"op": "grow", "steps": 5, "count": 5})"), "operations[0]: “count” is not known here");
    row(operations(R"({"op": "lasso", "points": [[0, 1], [2, 3]]})"),
        "operations[0].points: a lasso has at least three points");
    row(operations(R"({"op": "lasso", "points": [[0, 1], [2, 3], [1]]})"),
        "operations[0].points[2]: two numbers within");
    row(operations(R"({"op": "lasso", "points": [[0, 1], [2, 3], [1, 1001]]})"),
        "operations[0].points[2]: two numbers within");
    row(operations(R"({"op": "lasso", "up": [1, 0, 0], "points": [[0, 1], [2, 3], [1, 1]]})"),
        "operations[0].up: right and up must have length 1");
    row(operations(R"({"op": "lasso", "origin": [1, 0], "points": [[0, 1], [2, 3], [1, 1]]})"),
        "operations[0].origin: three numbers within");
    row(operations(R"({"op": "regrow", "steps": 2})"), "operations[0]: “steps” is not known here");
    row(operations(R"({"op": "undo", "count": -1})"), "operations[0].count: a whole number from 1 to 100000");
    row(operations(R"({"op": "setParameters"})"), "operations[0].parameters: it is missing");
    row(operations(R"({"op": "setParameters", "parameters": {"growth": {"x": 1}}})"),
        "operations[0].parameters.growth.x: there is no such parameter");
    row(recipe(R"("parameters": {"growht": {}})"), "parameters.growht: there is no such parameter");
    row(recipe(R"("parameters": {"growth": 1})"), "parameters.growth: an object is expected");
    row(recipe(R"("parameters": {"growth": {"shedding": "0.5"}})"),
        "parameters.growth.shedding: a number is expected");
    row(recipe(R"("parameters": {"growth": {"markerAge": 1.5}})"),
        "parameters.growth.markerAge: a whole number is expected");
    row(recipe(R"("parameters": {"growth": {"uprightTrunk": 1}})"),
        "parameters.growth.uprightTrunk: true or false is expected");
    row(recipe(R"("parameters": {"leaves": {"shape": "round"}})"),
        "parameters.leaves.shape: one of these is expected: ovate, lanceolate, lobed, needles");
    row(recipe(R"("parameters": {"leaves": {"shape": 1}})"),
        "parameters.leaves.shape: one of these is expected");
    row(recipe(R"("parameters": {"growth": {"axisWeight": 0, "tropismWeight": 0, "spaceWeight": 0}})"),
        "parameters.growth.axisWeight: axisWeight, tropismWeight and spaceWeight must not all be 0");
    row(recipe(R"("parameters": {"growth": {"ellipseOffset": -0.995}})"),
        "parameters.growth.ellipseOffset: it must not be beyond 0.99 times ellipseVertical, which is 1");
    row(operations(R"({"op": "setParameters", "parameters": {"growth": {"ellipseOffset": 0.9}}},
                      {"op": "setParameters", "parameters": {"growth": {"ellipseVertical": 0.9}}})"),
        "operations[1].parameters.growth.ellipseOffset: it must not be beyond 0.99 times ellipseVertical, "
        "which is 0.9");

    const auto stroke = [](const QByteArray& samples) {
        return operations(R"({"op": "brushStroke", "samples": [)" + samples + "]}");
    };
    row(stroke(""), "operations[0].samples: a stroke has at least one sample");
    row(operations(R"({"op": "brushStroke"})"), "operations[0].samples: a stroke has at least one");
    row(stroke("5"), "operations[0].samples[0]: an array of five numbers");
    row(stroke("[0,0,0,0]"), "operations[0].samples[0]: an array of five numbers is");
    row(stroke("[0,0,0,0,null]"), "operations[0].samples[0]: an array of five numbers is expected");
    row(stroke("[0,0,0,0,1,1]"), "operations[0].samples[0]: an array of five numbers is expected: time");
    row(stroke("[-0.1,0,0,0,1]"), "operations[0].samples[0]: the time is not within 0…600 s");
    row(stroke("[0,0,0,0,1],[600.5,0,0,0,1]"), "operations[0].samples[1]: the time is not within 0…600 s");
    row(stroke("[0,0,0,0,1],[1,0,0,0,1],[0.5,0,0,0,1]"),
        "operations[0].samples[2]: the time does not go forwards");
    row(stroke("[0,0,0,0,1],[1,0,0,0,1],[1,0,0,0,1],[0,0,0,0,1]"),
        "operations[0].samples[2]: the time does not go");
    row(stroke("[0,1000.5,0,0,1]"), "operations[0].samples[0]: a coordinate is not within ±1000 m");
    row(stroke("[0,0,0,-1e300,1]"), "operations[0].samples[0]: a coordinate is not within ±1000");
    row(stroke("[0,0,0,0,-0.01]"), "operations[0].samples[0]: the radius is not within 0…100 m");
    row(stroke("[0,0,0,0,100.01]"), "operations[0].samples[0]: the radius is not within 0…100");

    const auto bend = [](const QByteArray& handle, const QByteArray& rest = {}) {
        return operations(R"({"op": "bend", "base": 0, "handles": [)" + handle + "]" + rest + "}");
    };
    const QByteArray held = R"({"internode": 3, "target": [0, 1, 2]})";
    row(bend(""), "operations[0].handles: a bend has from 1 to 100 handles");
    row(bend(QByteArray(held + ',').repeated(100) + held), "operations[0].handles: a bend has from 1 to 100");
    row(operations(R"({"op": "bend", "handles": []})"), "operations[0].base: it is missing");
    row(bend("5"), "operations[0].handles[0]: an object is expected");
    row(bend(R"({"internode": -1, "target": [0, 1, 2]})"),
        "operations[0].handles[0].internode: a whole number from 0 to 4294967294");
    row(bend(R"({"internode": 3})"), "operations[0].handles[0].target: an array of three numbers");
    row(bend(held + R"(, {"internode": 3, "target": [0, 1]})"),
        "operations[0].handles[1].target: an array of three numbers within ±1000");
    row(bend(R"({"internode": 3, "target": [0, 1, 2, 3]})"),
        "operations[0].handles[0].target: an array of three numbers within");
    row(bend(R"({"internode": 3, "target": [0, "1", 2]})"),
        "operations[0].handles[0].target: an array of three numbers within ±");
    row(bend(R"({"internode": 3, "target": [0, 1000.5, 2]})"),
        "operations[0].handles[0].target: an array of three numbers within ±1000 is");
    row(bend(R"({"internode": 3, "along": 1.01, "target": [0, 1, 2]})"),
        "operations[0].handles[0].along: a number from 0 to 1 is expected");
    row(bend(R"({"internode": 3, "target": [0, 1, 2], "x": 1})"),
        "operations[0].handles[0]: “x” is not known");
    row(bend(held, R"(, "bending": 0)"), "operations[0].bending: a number from 0.01 to 100 is expected");
    row(bend(held, R"(, "stretching": "1")"),
        "operations[0].stretching: a number from 0.01 to 100 is expected");
    row(operations(R"({"op": "setWidth", "internode": 1})"), "operations[0].diameter: it is missing");
    row(operations(R"({"op": "setWidth", "internode": 1, "diameter": -0.1})"),
        "operations[0].diameter: a number from 0 to 100 is expected");
    row(operations(R"({"op": "setWidth", "internode": 4294967295, "diameter": 1})"),
        "operations[0].internode: a whole number from 0 to 4294967294 is");
}

void RecipeTest::wrongRecipes_nameThePlace()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, message);
    const Result<Recipe> result = parseRecipe(json);
    QVERIFY(!result);
    QCOMPARE(result.error().kind, Error::Kind::Input);
    QVERIFY2(result.error().message.startsWith(message), qPrintable(result.error().message));
}

void RecipeTest::wrongParameters_areAllRefusedJustBeyondTheirLimits()
{
    int tried = 0;
    TreeParameters parameters;
    visitParameters(parameters, [&](const ParameterInfo& info, const auto&) {
        if (info.quantity == Quantity::Switch || info.quantity == Quantity::Choice)
            return;
        const QStringList key = QString::fromLatin1(info.key).split(QLatin1Char('.'));
        const double step = info.quantity == Quantity::Count ? 1.0 : 1e-9;
        const auto set = [&](double value) {
            return bool(fromJson({{key[0], QJsonObject{{key[1], value}}}}, {}, QStringLiteral("p")));
        };
        ++tried;
        QVERIFY2(!set(info.minimum - step), info.key);
        QVERIFY2(!set(info.maximum + step), info.key);
        // The limits themselves are good, but for what depends on another parameter.
        if (QLatin1String(info.key) != QLatin1String("growth.ellipseOffset")) {
            QVERIFY2(set(info.minimum), info.key);
            QVERIFY2(set(info.maximum), info.key);
        }
    });
    QVERIFY(tried > 30);
}

void RecipeTest::hugeRecipes_areRefusedBeforeTheyAreParsed()
{
    Result<Recipe> result = parseRecipe(QByteArray(recipeLimits::kBytes + 1, ' '));
    QVERIFY(!result);
    QCOMPARE(result.error().message, QStringLiteral("it is larger than 64 MB"));

    result = parseRecipe(recipe("\"operations\": [" + QByteArray("[],").repeated(2'000'000) + "1]"));
    QVERIFY(!result);
    QCOMPARE(result.error().message, QStringLiteral("it holds too many values"));

    QByteArray samples;
    for (int i = 0; i <= recipeLimits::kSamples; ++i)
        samples += (samples.isEmpty() ? "[" : ",[") + QByteArray::number(i * 1e-5) + ",0,0,0,1]";
    result = parseRecipe(operations("{\"op\":\"brushStroke\",\"samples\":[" + samples + "]}"));
    QVERIFY(!result);
    QCOMPARE(result.error().message,
             QStringLiteral("operations[0].samples: a recipe has at most 1000000 samples"));

    result = parseRecipe(QByteArray("[").repeated(1'000'000));
    QVERIFY(!result);
}

void RecipeTest::missingFile_saysSo()
{
    QVERIFY(readRecipe(QStringLiteral("/nowhere/oak.json"))
                .error()
                .message.startsWith(QStringLiteral("oak.json: ")));
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("elm.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\n}");
    file.close();
    QVERIFY(readRecipe(file.fileName())
                .error()
                .message.startsWith(QStringLiteral("elm.json: this is no recipe")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(recipe(R"("name": "Elm")"));
    file.close();
    QCOMPARE(readRecipe(file.fileName())->name, QStringLiteral("Elm"));
}

namespace {

QByteArray contentOf(const char* name)
{
    QFile file(QStringLiteral(SOURCE_DIR "/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QJsonObject schema()
{
    return QJsonDocument::fromJson(contentOf("resources/recipe.schema.json")).object();
}

QString surfaceNumber(double number)
{
    return QString::number(number, 'g', 12);
}

} // namespace

void RecipeTest::schemaAndTable_agree()
{
    const QJsonObject groups =
        schema()[QLatin1String("$defs")][QLatin1String("parameters")][QLatin1String("properties")].toObject();
    QSet<QString> inSchema;
    for (const QString& group : groups.keys()) {
        QCOMPARE(groups[group][QLatin1String("additionalProperties")], QJsonValue(false));
        for (const QString& name : groups[group][QLatin1String("properties")].toObject().keys())
            inSchema.insert(group + QLatin1Char('.') + name);
    }
    QSet<QString> inTable;
    TreeParameters parameters;
    visitParameters(parameters, [&](const ParameterInfo& info, const auto&) {
        inTable.insert(QString::fromLatin1(info.key));
        const QStringList key = QString::fromLatin1(info.key).split(QLatin1Char('.'));
        const QJsonObject property = groups[key[0]][QLatin1String("properties")][key[1]].toObject();
        const QString type = property[QLatin1String("type")].toString();
        if (info.quantity == Quantity::Switch) {
            QCOMPARE(type, QStringLiteral("boolean"));
        } else if (info.quantity == Quantity::Choice) {
            const QStringList choices = QString::fromLatin1(info.choices).split(QLatin1Char(' '));
            QCOMPARE(property[QLatin1String("enum")].toArray(), QJsonArray::fromStringList(choices));
        } else {
            QCOMPARE(type,
                     info.quantity == Quantity::Count ? QStringLiteral("integer") : QStringLiteral("number"));
            QVERIFY2(property[QLatin1String("minimum")] == QJsonValue(info.minimum), info.key);
            QVERIFY2(property[QLatin1String("maximum")] == QJsonValue(info.maximum), info.key);
        }
    });
    visitImages(parameters, [&](const char* image, const ImageAsset&) {
        inTable.insert(QString::fromLatin1(image));
        const QStringList key = QString::fromLatin1(image).split(QLatin1Char('.'));
        const QJsonObject property = groups[key[0]][QLatin1String("properties")][key[1]].toObject();
        QCOMPARE(property[QLatin1String("type")].toString(), QStringLiteral("string"));
    });
    QCOMPARE(inSchema, inTable);
}

void RecipeTest::schemaAndLimits_agree()
{
    const QJsonObject root = schema();
    const QJsonObject defs = root[QLatin1String("$defs")].toObject();
    const auto property = [](const QJsonValue& object, const char* name) {
        return object[QLatin1String("properties")][QLatin1String(name)];
    };
    QCOMPARE(property(root, "espalier-recipe")[QLatin1String("const")].toInt(), recipeLimits::kVersion);
    QCOMPARE(property(root, "operations")[QLatin1String("maxItems")].toInteger(), recipeLimits::kOperations);
    QCOMPARE(property(defs[QLatin1String("grow")], "steps")[QLatin1String("maximum")].toInt(),
             recipeLimits::kGrowSteps);
    for (const char* op : {"undo", "redo"})
        QCOMPARE(property(defs[QLatin1String(op)], "count")[QLatin1String("maximum")].toInt(),
                 recipeLimits::kUndoCount);
    QCOMPARE(property(defs[QLatin1String("brushStroke")], "samples")[QLatin1String("maxItems")].toInteger(),
             recipeLimits::kSamples);
    const QJsonArray sample = defs[QLatin1String("sample")][QLatin1String("prefixItems")].toArray();
    QCOMPARE(sample.size(), 5);
    const double limits[5][2] = {{0, recipeLimits::kStrokeTime},
                                 {-recipeLimits::kCoordinate, recipeLimits::kCoordinate},
                                 {-recipeLimits::kCoordinate, recipeLimits::kCoordinate},
                                 {-recipeLimits::kCoordinate, recipeLimits::kCoordinate},
                                 {0, recipeLimits::kRadius}};
    for (qsizetype i = 0; i < 5; ++i) {
        QCOMPARE(sample.at(i)[QLatin1String("minimum")].toDouble(), limits[i][0]);
        QCOMPARE(sample.at(i)[QLatin1String("maximum")].toDouble(), limits[i][1]);
    }
    const QJsonValue bend = defs[QLatin1String("bend")];
    for (const char* weight : {"bending", "stretching"}) {
        QCOMPARE(property(bend, weight)[QLatin1String("minimum")].toDouble(), recipeLimits::kLeastWeight);
        QCOMPARE(property(bend, weight)[QLatin1String("maximum")].toDouble(), recipeLimits::kGreatestWeight);
    }
    const QJsonValue handles = property(bend, "handles");
    QCOMPARE(handles[QLatin1String("maxItems")].toInteger(), recipeLimits::kHandles);
    const QJsonValue target = property(handles[QLatin1String("items")], "target")[QLatin1String("items")];
    QCOMPARE(target[QLatin1String("minimum")].toDouble(), -recipeLimits::kCoordinate);
    QCOMPARE(target[QLatin1String("maximum")].toDouble(), recipeLimits::kCoordinate);
    QCOMPARE(property(defs[QLatin1String("setWidth")], "diameter")[QLatin1String("maximum")].toDouble(),
             recipeLimits::kDiameter);
    QCOMPARE(defs[QLatin1String("internode")][QLatin1String("maximum")].toInteger(),
             recipeLimits::kInternode);
    // The members that the schema names are those that the parser takes: each alone is no surplus to it.
    for (const QString& member : root[QLatin1String("properties")].toObject().keys()) {
        const QJsonObject json{{QStringLiteral("espalier-recipe"), 1}, {member, 1}};
        const Result<Recipe> result = parseRecipe(QJsonDocument(json).toJson());
        QVERIFY(result || !result.error().message.contains(QStringLiteral("not known")));
    }
    QStringList operationNames;
    for (const QJsonValue& item :
         property(root, "operations")[QLatin1String("items")][QLatin1String("oneOf")].toArray())
        operationNames.append(item[QLatin1String("$ref")].toString().section(QLatin1Char('/'), -1));
    QCOMPARE(operationNames.size(), std::variant_size_v<RecipeOperation>);
    for (const QString& name : operationNames) {
        QCOMPARE(property(defs[name], "op")[QLatin1String("const")].toString(), name);
        const Result<Recipe> result = parseRecipe(operations("{\"op\":\"" + name.toLatin1() + "\"}"));
        QVERIFY(result || !result.error().message.contains(QStringLiteral("there is no operation")));
    }
}

void RecipeTest::documentation_hasEveryParameterWithItsLimits()
{
    const QString text = QString::fromUtf8(contentOf("docs/recipes.md"));
    TreeParameters parameters;
    visitParameters(parameters, [&](const ParameterInfo& info, const auto&) {
        QString range;
        if (info.quantity == Quantity::Switch)
            range = QStringLiteral("true or false");
        else if (info.quantity == Quantity::Choice)
            range = QLatin1Char('`') +
                    QString::fromLatin1(info.choices).replace(QLatin1String(" "), QLatin1String("`, `")) +
                    QLatin1Char('`');
        else
            range = QStringLiteral("%1 … %2%3")
                        .arg(surfaceNumber(info.minimum), surfaceNumber(info.maximum),
                             info.quantity == Quantity::Angle ? QStringLiteral("°") : QString());
        const QString name = QString::fromLatin1(info.key).section(QLatin1Char('.'), -1);
        QVERIFY2(text.contains(QStringLiteral("\n| `%1` | %2 | ").arg(name, range)), info.key);
    });
    visitImages(parameters, [&](const char* key, const ImageAsset&) {
        const QString name = QString::fromLatin1(key).section(QLatin1Char('.'), -1);
        QVERIFY2(text.contains(QStringLiteral("\n| `%1` | a file, or `\"\"` | ").arg(name)), key);
    });
}

void RecipeTest::documentation_examplesAreRecipes()
{
    const QString text = QString::fromUtf8(contentOf("docs/recipes.md"));
    static const QRegularExpression example(QStringLiteral("```json\n(.*?)```"),
                                            QRegularExpression::DotMatchesEverythingOption);
    QSet<std::size_t> seen;
    int count = 0;
    for (auto match = example.globalMatch(text); match.hasNext(); ++count) {
        const QString json = match.next().captured(1);
        const Result<Recipe> result = parseRecipe(json.toUtf8());
        QVERIFY2(result, qPrintable((result ? QString() : result.error().message) + json));
        for (const RecipeOperation& operation : result->operations)
            seen.insert(operation.index());
    }
    QVERIFY(count >= 5);
    QCOMPARE(seen.size(), static_cast<qsizetype>(std::variant_size_v<RecipeOperation>));
}

void RecipeTest::sampleRecipes_areRecipes()
{
    const QDir folder(QStringLiteral(SOURCE_DIR "/resources/recipes"));
    const QStringList names = folder.entryList({QStringLiteral("*.json")});
    QVERIFY(!names.isEmpty());
    for (const QString& name : names) {
        const Result<Recipe> result = readRecipe(folder.filePath(name));
        QVERIFY2(result, result ? "" : qPrintable(result.error().message));
        QVERIFY(!result->name.isEmpty());
    }
}

static const TestClass<RecipeTest> recipeTest;

} // namespace espalier::test

#include "RecipeTest.moc"

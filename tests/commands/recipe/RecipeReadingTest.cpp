// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/commands/recipe/RecipeTexts.h"
#include "tests/support/AllOperations.h"
#include "tests/support/TestClasses.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace espalier::test {

class RecipeReadingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyOperation_isRead();
    void setParameters_buildsOnThoseBefore();
    void weights_areScaledToSumToOne();
    void seeds_areNumbersOrStrings();
    void missingFile_saysSo();
};

void RecipeReadingTest::everyOperation_isRead()
{
    const Result<Recipe> result = parseRecipe(recipeOf(R"(
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
    lasso.only = {5U, kTerminalSlot};
    const std::vector<RecipeOperation> expected{
        stroke,
        GrowOperation{7},
        PruneOperation{{12U, 3U}},
        GrowOperation{2, {4U, 1}},
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

void RecipeReadingTest::setParameters_buildsOnThoseBefore()
{
    const Result<Recipe> result =
        parseRecipe(recipeOf(R"("parameters": {"growth": {"irregularity": 0.125}}, "operations": [
        {"op": "setParameters", "parameters": {"growth": {"shedding": 0.25}}},
        {"op": "setParameters", "parameters": {"growth": {"shedding": 0.75, "maxShootLength": 9}}}])"));
    QVERIFY(result);
    const auto& growth = result->operations[1].as<SetParametersOperation>()->parameters.growth;
    QCOMPARE(growth.irregularity, 0.125);
    QCOMPARE(growth.shedding, 0.75);
    QCOMPARE(growth.maxShootLength, 9);
}

void RecipeReadingTest::weights_areScaledToSumToOne()
{
    const Result<Recipe> result = parseRecipe(recipeOf(
        R"("parameters": {"growth": {"axisWeight": 1, "tropismWeight": 0.25, "spaceWeight": 0.75}},
           "operations": [{"op": "setParameters", "parameters": {"growth": {"axisWeight": 0.5}}}])"));
    QVERIFY(result);
    QCOMPARE(result->parameters.growth.axisWeight, 0.5);
    QCOMPARE(result->parameters.growth.tropismWeight, 0.125);
    QCOMPARE(result->parameters.growth.spaceWeight, 0.375);
    // Weights that sum to 1 already keep their bits.
    const auto& later = result->operations[0].as<SetParametersOperation>()->parameters;
    QVERIFY(later == result->parameters);
}

void RecipeReadingTest::seeds_areNumbersOrStrings()
{
    QCOMPARE(parseRecipe(recipeOf(R"("seed": 9007199254740992)"))->seed, 9007199254740992U);
    QCOMPARE(parseRecipe(recipeOf(R"("seed": "18446744073709551615")"))->seed, 18446744073709551615U);
    QCOMPARE(parseRecipe(recipeOf(R"("seed": "0012")"))->seed, 12U);
    QCOMPARE(parseRecipe(recipeOf(R"("name": "")"))->seed, 1U);
}

void RecipeReadingTest::missingFile_saysSo()
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
                .message.startsWith(QStringLiteral("elm.json: this is not a recipe")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(recipeOf(R"("name": "Elm")"));
    file.close();
    QCOMPARE(readRecipe(file.fileName())->name, QStringLiteral("Elm"));
}

static const TestClass<RecipeReadingTest> recipeReadingTest;

} // namespace espalier::test

#include "RecipeReadingTest.moc"

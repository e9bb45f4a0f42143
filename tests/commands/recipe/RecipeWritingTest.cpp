// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "tests/commands/recipe/RandomRecipe.h"
#include "tests/support/TestClasses.h"

#include <QJsonDocument>
#include <QTest>

#include <bit>
#include <cmath>

namespace espalier::test {

class RecipeWritingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void writtenRecipe_readsBackTheSame_data();
    void writtenRecipe_readsBackTheSame();
    void writtenRecipe_isReadable();
    void longRecipe_isOneLine();
    void everyFloat_roundTripsWithFewDigits();
    void operation_isWrittenWithoutAPlayer();
    void parameters_roundTripToTheLastBit();
    void degrees_areWrittenShort();
};

void RecipeWritingTest::writtenRecipe_readsBackTheSame_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 20; ++seed)
        QTest::addRow("%d", seed) << seed;
}

void RecipeWritingTest::writtenRecipe_readsBackTheSame()
{
    QFETCH(int, seed);
    const Recipe original = randomRecipe(static_cast<std::uint64_t>(seed));
    const QByteArray json = writeRecipe(original);
    const Result<Recipe> back = parseRecipe(json);
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(*back == original);
    QCOMPARE(writeRecipe(*back), json);
}

void RecipeWritingTest::writtenRecipe_isReadable()
{
    Recipe original;
    original.name = QStringLiteral("Elm");
    original.operations = {
        BrushStrokeOperation{{{0.1, Vec3(0.1F, -2, 0), 0.3F}, {0.2, Vec3(1e-7F, 3.25F, 1), 0}}},
        GrowOperation{3}};
    const QByteArray json = writeRecipe(original);
    for (const char* line :
         {"\n            \"op\": \"grow\",\n", "\n            \"steps\": 3\n", "\n    \"name\": \"Elm\",\n",
          "\n                    0.3\n", "\n                    1e-07,\n", "\n    \"seed\": 1\n"})
        QVERIFY2(json.contains(line), json.constData());
}

void RecipeWritingTest::longRecipe_isOneLine()
{
    const QByteArray json = writeRecipe(randomRecipe(3));
    QVERIFY(json.size() > recipeLimits::kIndentedBytes);
    QVERIFY(!json.contains("\n "));
}

void RecipeWritingTest::everyFloat_roundTripsWithFewDigits()
{
    Random random(1, 0, 0, Purpose::Direction);
    for (int i = 0; i < 200'000; ++i) {
        const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(random.bits()));
        if (!std::isfinite(number))
            continue;
        const QByteArray json =
            QJsonDocument(QJsonArray{shortestDouble(number)}).toJson(QJsonDocument::Compact);
        // Qt writes whole numbers below 2^63 with all their digits.
        QVERIFY2(json.size() <= 22, json.constData());
        const double back = QJsonDocument::fromJson(json).array().at(0).toDouble();
        QCOMPARE(static_cast<float>(back), number);
    }
}

void RecipeWritingTest::operation_isWrittenWithoutAPlayer()
{
    RecipeWriting writing;
    const RecipeOperation prune = PruneOperation{{4U, 9U}};
    QCOMPARE(QJsonDocument(prune.write(writing)).toJson(QJsonDocument::Compact),
             QByteArray(R"({"internodes":[4,9],"op":"prune"})"));
    // Parameters are written as differences from those before.
    TreeParameters parameters;
    parameters.growth.shedding = 0.25;
    QCOMPARE(QJsonDocument(RecipeOperation(SetParametersOperation{parameters}).write(writing))
                 .toJson(QJsonDocument::Compact),
             QByteArray(R"({"op":"setParameters","parameters":{"growth":{"shedding":0.25}}})"));
    parameters.growth.maxShootLength = 9;
    QCOMPARE(QJsonDocument(RecipeOperation(SetParametersOperation{parameters}).write(writing))
                 .toJson(QJsonDocument::Compact),
             QByteArray(R"({"op":"setParameters","parameters":{"growth":{"maxShootLength":9}}})"));
}

void RecipeWritingTest::parameters_roundTripToTheLastBit()
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

void RecipeWritingTest::degrees_areWrittenShort()
{
    TreeParameters parameters;
    for (const double angle : {137.5, 0.1, 33.3, 59.9, 1e-9, 52.0}) {
        parameters.growth.phyllotaxis = radians(angle);
        QCOMPARE(toJson(parameters)[QLatin1String("growth")][QLatin1String("phyllotaxis")].toDouble(), angle);
    }
}

static const TestClass<RecipeWritingTest> recipeWritingTest;

} // namespace espalier::test

#include "RecipeWritingTest.moc"

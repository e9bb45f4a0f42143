// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipeLimits.h"
#include "tests/commands/recipe/RecipeTexts.h"
#include "tests/support/AllOperations.h"
#include "tests/support/TestClasses.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

namespace espalier::test {

class RecipeSchemaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void schemaAndTable_agree();
    void schemaAndLimits_agree();
    void documentation_hasEveryParameterWithItsLimits();
    void documentation_examplesAreRecipes();
    void sampleRecipes_areRecipes();
};

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

void RecipeSchemaTest::schemaAndTable_agree()
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

void RecipeSchemaTest::schemaAndLimits_agree()
{
    const QJsonObject root = schema();
    const QJsonObject defs = root[QLatin1String("$defs")].toObject();
    const auto property = [](const QJsonValue& object, const char* name) {
        return object[QLatin1String("properties")][QLatin1String(name)];
    };
    QCOMPARE(property(root, "espalier-recipe")[QLatin1String("enum")].toArray().last().toInt(),
             recipeLimits::kVersion);
    QCOMPARE(property(root, "operations")[QLatin1String("maxItems")].toInteger(), recipeLimits::kOperations);
    QCOMPARE(property(defs[QLatin1String("grow")], "steps")[QLatin1String("maximum")].toInt(),
             GrowOperation::kMostSteps);
    for (const char* op : {"undo", "redo"})
        QCOMPARE(property(defs[QLatin1String(op)], "count")[QLatin1String("maximum")].toInt(),
                 UndoOperation::kMostCount);
    QCOMPARE(property(defs[QLatin1String("brushStroke")], "samples")[QLatin1String("maxItems")].toInteger(),
             recipeLimits::kSamples);
    const QJsonArray sample = defs[QLatin1String("sample")][QLatin1String("prefixItems")].toArray();
    QCOMPARE(sample.size(), 5);
    const double limits[5][2] = {{0, BrushStrokeOperation::kGreatestTime},
                                 {-recipeLimits::kCoordinate, recipeLimits::kCoordinate},
                                 {-recipeLimits::kCoordinate, recipeLimits::kCoordinate},
                                 {-recipeLimits::kCoordinate, recipeLimits::kCoordinate},
                                 {0, BrushStrokeOperation::kGreatestRadius}};
    for (qsizetype i = 0; i < 5; ++i) {
        QCOMPARE(sample.at(i)[QLatin1String("minimum")].toDouble(), limits[i][0]);
        QCOMPARE(sample.at(i)[QLatin1String("maximum")].toDouble(), limits[i][1]);
    }
    const QJsonValue bend = defs[QLatin1String("bend")];
    for (const char* weight : {"bending", "stretching"}) {
        QCOMPARE(property(bend, weight)[QLatin1String("minimum")].toDouble(), BendOperation::kLeastWeight);
        QCOMPARE(property(bend, weight)[QLatin1String("maximum")].toDouble(), BendOperation::kGreatestWeight);
    }
    const QJsonValue handles = property(bend, "handles");
    QCOMPARE(handles[QLatin1String("maxItems")].toInteger(), BendOperation::kMostHandles);
    const QJsonValue target = property(handles[QLatin1String("items")], "target")[QLatin1String("items")];
    QCOMPARE(target[QLatin1String("minimum")].toDouble(), -recipeLimits::kCoordinate);
    QCOMPARE(target[QLatin1String("maximum")].toDouble(), recipeLimits::kCoordinate);
    QCOMPARE(property(defs[QLatin1String("setWidth")], "diameter")[QLatin1String("maximum")].toDouble(),
             double{kGreatestDiameter});
    QCOMPARE(
        defs[QLatin1String("internode")][QLatin1String("oneOf")][0][QLatin1String("maximum")].toInteger(),
        InternodeReference::kGreatestNumber);
    // The parser accepts each member that the schema names.
    for (const QString& member : root[QLatin1String("properties")].toObject().keys()) {
        const QJsonObject json{{QStringLiteral("espalier-recipe"), 1}, {member, 1}};
        const Result<Recipe> result = parseRecipe(QJsonDocument(json).toJson());
        QVERIFY(result || !result.error().message.contains(QStringLiteral("not known")));
    }
    QStringList names;
    for (const QJsonValue& item :
         property(root, "operations")[QLatin1String("items")][QLatin1String("oneOf")].toArray())
        names.append(item[QLatin1String("$ref")].toString().section(QLatin1Char('/'), -1));
    QStringList known = operationNames();
    known.sort();
    names.sort();
    QCOMPARE(names, known);
    for (const QString& name : names) {
        QCOMPARE(property(defs[name], "op")[QLatin1String("const")].toString(), name);
        const Result<Recipe> result = parseRecipe(operationsOf("{\"op\":\"" + name.toLatin1() + "\"}"));
        QVERIFY(result || !result.error().message.contains(QStringLiteral("there is no operation")));
    }
}

void RecipeSchemaTest::documentation_hasEveryParameterWithItsLimits()
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

void RecipeSchemaTest::documentation_examplesAreRecipes()
{
    const QString text = QString::fromUtf8(contentOf("docs/recipes.md"));
    static const QRegularExpression example(QStringLiteral("```json\n(.*?)```"),
                                            QRegularExpression::DotMatchesEverythingOption);
    QStringList seen;
    int count = 0;
    for (auto match = example.globalMatch(text); match.hasNext(); ++count) {
        const QString json = match.next().captured(1);
        const Result<Recipe> result = parseRecipe(json.toUtf8());
        QVERIFY2(result, qPrintable((result ? QString() : result.error().message) + json));
        for (const RecipeOperation& operation : result->operations)
            seen.append(operation.name());
    }
    QVERIFY(count >= 5);
    for (const QString& name : operationNames())
        QVERIFY2(seen.contains(name), qPrintable(name));
}

void RecipeSchemaTest::sampleRecipes_areRecipes()
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

static const TestClass<RecipeSchemaTest> recipeSchemaTest;

} // namespace espalier::test

#include "RecipeSchemaTest.moc"

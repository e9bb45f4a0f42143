// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/CommandLine.h"

#include "commands/recipe/GrowOperation.h"
#include "commands/recipe/SetParametersOperation.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

using namespace espalier;

class CommandLineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothing_opensAnEmptyWindow();
    void project_opensAWindowWithIt();
    void replay_takesRecipesOutputsAndOptionsInAnyOrder();
    void transparent_isAskedForWithoutAValue();
    void doubleDash_endsTheOptions();
    void demo_takesARecipeOrNone();
    void set_readsEveryKindOfValue();
    void set_isTakenByEveryVerbThatMakesSomething();
    void set_winsOverContradictions();
    void set_holdsForAllOfARecipe();
    void vary_takesASeedAndAnAmount();
    void wrongLines_saySo_data();
    void wrongLines_saySo();
};

void CommandLineTest::nothing_opensAnEmptyWindow()
{
    const Result<CommandLine> line = parseCommandLine({});
    QVERIFY(line);
    QCOMPARE(line->verb, CommandLine::Verb::Window);
    QVERIFY(line->inputs.isEmpty());
    QVERIFY(line->needsDisplay());
}

void CommandLineTest::project_opensAWindowWithIt()
{
    const Result<CommandLine> line = parseCommandLine({QStringLiteral("oak.espalier")});
    QVERIFY(line);
    QCOMPARE(line->verb, CommandLine::Verb::Window);
    QCOMPARE(line->inputs, QStringList{QStringLiteral("oak.espalier")});
}

void CommandLineTest::replay_takesRecipesOutputsAndOptionsInAnyOrder()
{
    const QString words = QStringLiteral(
        "replay -o t.espalier a.json --size 640x480 b.json -o t.FBX --png t.png "
        "--camera three-quarter --stats=s.json --threads 2 --seed 18446744073709551615 --strict");
    const Result<CommandLine> line = parseCommandLine(words.split(QLatin1Char(' ')));
    QVERIFY(line);
    QCOMPARE(line->verb, CommandLine::Verb::Replay);
    QCOMPARE(line->inputs, (QStringList{QStringLiteral("a.json"), QStringLiteral("b.json")}));
    QCOMPARE(line->outputs, (QStringList{QStringLiteral("t.espalier"), QStringLiteral("t.FBX")}));
    QCOMPARE(line->size, QSize(640, 480));
    QCOMPARE(line->camera, QStringLiteral("three-quarter"));
    QCOMPARE(line->picture, QStringLiteral("t.png"));
    QCOMPARE(line->stats, QStringLiteral("s.json"));
    QVERIFY(line->strict);
    QCOMPARE(line->threads, 2);
    QCOMPARE(line->seed, std::optional<std::uint64_t>(18446744073709551615U));
    QVERIFY(line->needsDisplay());
    QVERIFY(!parseCommandLine({QStringLiteral("replay"), QStringLiteral("a.json")})->needsDisplay());
    QVERIFY(!parseCommandLine({QStringLiteral("replay"), QStringLiteral("a.json")})->strict);
}

void CommandLineTest::transparent_isAskedForWithoutAValue()
{
    const Result<CommandLine> line = parseCommandLine(
        {QStringLiteral("render"), QStringLiteral("--transparent"), QStringLiteral("t.espalier"),
         QStringLiteral("--png"), QStringLiteral("t.png"), QStringLiteral("--ground-shadow")});
    QVERIFY(line);
    QVERIFY(line->transparent && line->groundShadow);
    QCOMPARE(line->inputs, QStringList{QStringLiteral("t.espalier")});
}

void CommandLineTest::doubleDash_endsTheOptions()
{
    const Result<CommandLine> line =
        parseCommandLine({QStringLiteral("replay"), QStringLiteral("--"), QStringLiteral("-o")});
    QVERIFY(line);
    QCOMPARE(line->inputs, QStringList{QStringLiteral("-o")});
}

void CommandLineTest::demo_takesARecipeOrNone()
{
    QCOMPARE(parseCommandLine({QStringLiteral("--demo")})->verb, CommandLine::Verb::Demo);
    const Result<CommandLine> line = parseCommandLine({QStringLiteral("--demo"), QStringLiteral("oak.json")});
    QVERIFY(line);
    QCOMPARE(line->verb, CommandLine::Verb::Demo);
    QCOMPARE(line->inputs, QStringList{QStringLiteral("oak.json")});
}

namespace {

Result<CommandLine> replayWith(const QStringList& values)
{
    QStringList words{QStringLiteral("replay"), QStringLiteral("a.json")};
    for (const QString& value : values)
        words << QStringLiteral("--set") << value;
    return parseCommandLine(words);
}

} // namespace

void CommandLineTest::set_readsEveryKindOfValue()
{
    const Result<CommandLine> line =
        replayWith({QStringLiteral("growth.shedding=0.25"), QStringLiteral("growth.branchingAngle=33"),
                    QStringLiteral("growth.maxShootLength=4"), QStringLiteral("leaves.visible=false"),
                    QStringLiteral("wood.mesher=strands"), QStringLiteral("growth.shedding=0.5"),
                    QStringLiteral("growth.ellipseOffset=-0.3")});
    QVERIFY2(line, line ? "" : qPrintable(line.error().message));
    TreeParameters wanted;
    wanted.growth.shedding = 0.5; // The last one counts.
    wanted.growth.branchingAngle = radians(33);
    wanted.growth.maxShootLength = 4;
    wanted.growth.ellipseOffset = -0.3;
    wanted.leaves.visible = false;
    wanted.wood.mesher = WoodMesherKind::Strands;
    QCOMPARE(line->overrides.appliedTo(TreeParameters()), wanted);
    QVERIFY(parseCommandLine({QStringLiteral("replay"), QStringLiteral("a.json")})->overrides.isEmpty());
    // Each parameter has a name here.
    TreeParameters defaults;
    visitParameters(defaults, [](const ParameterInfo& info, const auto&) {
        QString least = QString::number(std::max(info.minimum, 0.05));
        if (info.quantity == Quantity::Choice)
            least = QString::fromLatin1(info.choices).section(QLatin1Char(' '), 0, 0);
        else if (info.quantity == Quantity::Switch)
            least = QStringLiteral("true");
        else if (info.quantity == Quantity::Count)
            least = QString::number(info.maximum);
        const Result<CommandLine> one =
            replayWith({QStringLiteral("%1=%2").arg(QString::fromLatin1(info.key), least)});
        QVERIFY2(one, one ? "" : qPrintable(one.error().message));
    });
}

void CommandLineTest::set_isTakenByEveryVerbThatMakesSomething()
{
    for (const char* words :
         {"replay a.json --set growth.shedding=0.3", "export --set=growth.shedding=0.3 a.espalier",
          "render a.espalier --png a.png --set growth.shedding=0.3"}) {
        const Result<CommandLine> line = parseCommandLine(QString::fromLatin1(words).split(QLatin1Char(' ')));
        QVERIFY2(line, words);
        QCOMPARE(line->overrides.appliedTo(TreeParameters()).growth.shedding, 0.3);
        QCOMPARE(line->inputs.size(), 1);
    }
}

void CommandLineTest::set_winsOverContradictions()
{
    TreeParameters parameters;
    parameters.growth.axisWeight = 0.2;
    parameters.growth.tropismWeight = 0.2;
    parameters.growth.spaceWeight = 0.6;
    parameters.growth.ellipseVertical = 0.5;
    parameters.growth.ellipseOffset = 0.4;
    const auto applied = [&](const QStringList& values) {
        const Result<CommandLine> line = replayWith(values);
        return line ? line->overrides.appliedTo(parameters).growth : GrowthParameters{.axisWeight = -1.0};
    };
    const GrowthParameters axis = applied({QStringLiteral("growth.axisWeight=0.6")});
    QVERIFY(std::abs(axis.axisWeight - 0.6) < 1e-12);
    QVERIFY(std::abs(axis.tropismWeight - 0.1) < 1e-12 && std::abs(axis.spaceWeight - 0.3) < 1e-12);
    const GrowthParameters two =
        applied({QStringLiteral("growth.axisWeight=1"), QStringLiteral("growth.spaceWeight=1")});
    QVERIFY(std::abs(two.axisWeight - 0.5) < 1e-12 && two.tropismWeight == 0.0);
    QVERIFY(applied({QStringLiteral("growth.ellipseOffset=1")}).ellipseVertical > 1.0);
    QCOMPARE(applied({QStringLiteral("growth.ellipseOffset=1")}).ellipseOffset, 1.0);
    QCOMPARE(applied({QStringLiteral("growth.ellipseVertical=0.2")}).ellipseVertical, 0.2);
    QVERIFY(applied({QStringLiteral("growth.ellipseVertical=0.2")}).ellipseOffset < 0.2);
}

void CommandLineTest::set_holdsForAllOfARecipe()
{
    const Result<CommandLine> line = replayWith({QStringLiteral("growth.shedding=0.5")});
    QVERIFY(line);
    TreeParameters other;
    other.growth.shedding = 0.1;
    other.growth.maxShootLength = 7;
    Recipe recipe;
    recipe.operations.emplace_back(GrowOperation{});
    recipe.operations.emplace_back(SetParametersOperation{other});
    line->overrides.applyTo(recipe);
    other.growth.shedding = 0.5;
    QCOMPARE(recipe.parameters.growth.shedding, 0.5);
    QVERIFY(recipe.operations[0] == RecipeOperation(GrowOperation{}));
    QCOMPARE(recipe.operations[1].as<SetParametersOperation>()->parameters, other);
}

void CommandLineTest::vary_takesASeedAndAnAmount()
{
    const auto variationOf = [](const char* words) {
        const Result<CommandLine> line = parseCommandLine(QString::fromLatin1(words).split(QLatin1Char(' ')));
        return line ? line->variation : std::nullopt;
    };
    QCOMPARE(variationOf("export a.espalier -o a.glb"), std::optional<VaryOperation>());
    QCOMPARE(variationOf("export a.espalier -o a.glb --vary 7"),
             std::optional(VaryOperation{.seed = 7, .amount = 0.3}));
    QCOMPARE(variationOf("replay a.json --vary 18446744073709551615:1"),
             std::optional(VaryOperation{.seed = 18446744073709551615U, .amount = 1.0}));
    QCOMPARE(variationOf("render a.espalier --png a.png --vary=0:0.01"),
             std::optional(VaryOperation{.seed = 0, .amount = 0.01}));
}

void CommandLineTest::wrongLines_saySo_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("mentions");
    const auto add = [](const char* words, const char* mentions) {
        QTest::newRow(words) << QString::fromLatin1(words) << QString::fromUtf8(mentions);
    };
    add("replay", "recipe");
    add("replay a.json -o", "-o needs a value");
    add("replay a.json -o t.blend", "t.blend");
    add("replay a.json -o t", "suffix");
    add("replay a.json --size 0x10", "0x10");
    add("replay a.json --size 640", "640");
    add("replay a.json --size 99999x1", "99999x1");
    add("replay a.json --camera below", "below");
    add("replay a.json --threads 0", "--threads");
    add("replay a.json --threads two", "two");
    add("replay a.json --seed -1", "-1");
    add("replay a.json --frobnicate", "--frobnicate");
    add("replay a.json --png=", "--png needs a value");
    add("replay a.json --png", "--png needs a value");
    add("replay a.json -x", "replay has no option -x");
    add("replay a.json --stats s.json --help", "replay has no option --help");
    add("replay a.json --set", "--set needs a value");
    add("replay a.json --set growth.shedding", "--set needs group.name=value, not \"growth.shedding\"");
    add("replay a.json --set =0.3", "--set needs group.name=value, not \"=0.3\"");
    add("replay a.json --set growth.sheding=0.3", "--set: there is no parameter \"growth.sheding\"");
    add("replay a.json --set shedding=0.3", "--set: there is no parameter \"shedding\"");
    add("replay a.json --set leaves.image=a.png", "--set: there is no parameter \"leaves.image\"");
    add("replay a.json --set growth.shedding=1.5", "--set growth.shedding: 1.5 is not within 0…1");
    add("replay a.json --set growth.shedding=much", "--set growth.shedding: a number is expected");
    add("replay a.json --set growth.shedding=inf", "--set growth.shedding: a number is expected");
    add("replay a.json --set growth.shedding=", "--set growth.shedding: a number is expected");
    add("replay a.json --set growth.maxShootLength=2.5", "a whole number is expected");
    add("replay a.json --set leaves.visible=1", "--set leaves.visible: true or false is expected");
    add("render a.espalier --png a.png --set bark.kind=elm",
        "--set bark.kind: one of these is expected: fur");
    add("replay a.json --set growth.axisWeight=0 --set growth.tropismWeight=0 --set growth.spaceWeight=0",
        "must not all be 0");
    add("export a.espalier --set growth.ellipseVertical=0.2 --set growth.ellipseOffset=0.3",
        "--set growth.ellipseOffset: it must not exceed");
    for (const char* words :
         {"replay a.json --vary -1", "replay a.json --vary oak",
          "replay a.json --vary 1:", "replay a.json --vary 1:0", "replay a.json --vary 1:1.1",
          "replay a.json --vary 1:nan", "replay a.json --vary 1:0.5:2"})
        add(words, "--vary needs a whole number from 0");
    add("import a.csv -o a.obj --vary 1", "import has no option --vary");
    add("info a.espalier --set growth.shedding=0.3", "info has no option --set");
    add("import a.csv -o a.obj --set growth.shedding=0.3", "import has no option --set");
    add("--demo --set growth.shedding=0.3", "espalier has no option --set");
    add("--demo --seed 3", "espalier has no option --seed");
    add("export", "project");
    add("export a.espalier b.espalier", "one project");
    add("export a.espalier --stats s.json", "--stats");
    add("export a.espalier --strict", "--strict");
    add("render a.espalier", "--png");
    add("render a.espalier --png a.png --ground-shadow", "--transparent");
    add("render a.espalier --png a.png --transparent=yes", "no value");
    add("replay a.json --transparent", "--png");
    add("replay a.json --fibres", "--png");
    add("info", "file");
    add("--colour", "--colour");
    add("a.espalier b.espalier", "b.espalier");
}

void CommandLineTest::wrongLines_saySo()
{
    QFETCH(QString, words);
    QFETCH(QString, mentions);
    const Result<CommandLine> line = parseCommandLine(words.split(QLatin1Char(' ')));
    QVERIFY(!line);
    QVERIFY2(line.error().message.contains(mentions), qPrintable(line.error().message));
    QVERIFY(!line.error().message.contains(QLatin1Char('\n')));
}

static const test::TestClass<CommandLineTest> commandLineTest;

#include "CommandLineTest.moc"

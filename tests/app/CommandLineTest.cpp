// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/CommandLine.h"

#include "tests/support/TestClasses.h"

#include <QTest>

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

void CommandLineTest::wrongLines_saySo_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("mentions");
    const auto add = [](const char* words, const char* mentions) {
        QTest::newRow(words) << QString::fromLatin1(words) << QString::fromLatin1(mentions);
    };
    add("replay", "recipe");
    add("replay a.json -o", "-o wants a value");
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
    add("replay a.json --png=", "--png wants a value");
    add("replay a.json --png", "--png wants a value");
    add("replay a.json -x", "replay knows no option -x");
    add("replay a.json --stats s.json --help", "replay knows no option --help");
    add("--demo --seed 3", "espalier knows no option --seed");
    add("export", "project");
    add("export a.espalier b.espalier", "one project");
    add("export a.espalier --stats s.json", "--stats");
    add("export a.espalier --strict", "--strict");
    add("render a.espalier", "--png");
    add("render a.espalier --png a.png --ground-shadow", "--transparent");
    add("render a.espalier --png a.png --transparent=yes", "no value");
    add("replay a.json --transparent", "--png");
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/TestClasses.h"
#include "tests/support/ZipEntries.h"

#include <QProcess>
#include <QProcessEnvironment>
#include <QTest>

#include <sys/resource.h>

#include <csignal>

/// The built program, called as from a script.
class ProgramTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void chosenLanguage_isSpoken();
    void replay_writesEveryOutputAndNothingElse();
    void replay_continuesOneTreeThroughSeveralRecipes();
    void replay_takesTheSeedOfTheCommandLine();
    void replay_takesParametersOfTheCommandLine();
    void vary_makesOtherTreesOfTheSameKind();
    void exportAndRender_takeParametersForTheirOutputAlone();
    void replayOfAProject_givesTheSameProject();
    void replayOfAnOldProject_saysWhichStepsAreNotKnown();
    void replayOfAProject_saysIfAnotherTreeComesOfIt();
    void replay_namesWhatOperationsDoNotFind();
    void strictReplay_writesNothingIfAnOperationFindsNothing();
    void replay_givesTheSameBytesOnOneThreadAndOnTwo_data();
    void replay_givesTheSameBytesOnOneThreadAndOnTwo();
    void stats_haveTheirForm();
    void exportedProject_equalsReplayedExports();
    void sketch_makesATreeOfADrawing();
    void info_describesAProject();
    void helpAndVersion_goToStandardOutput();
    void failures_areOneLineAndACode_data();
    void failures_areOneLineAndACode();
    void failedOutput_leavesTheOldFile();
    void failedOutput_leavesTheOthersOut();
    void texturesOfAnOutput_leaveTheOthersTheirNames();
    void diskThatTakesNothing_leavesOldFilesAndFails_data();
    void diskThatTakesNothing_leavesOldFilesAndFails();
    void fullDisk_isSaidInWords();
    void growthWithoutEnd_stopsAtTheMemory();
    void argumentsThatAreNotText_areRefused();
    void picture_isDrawnOnADisplay();
    void demonstration_onAVirtualDisplay_writesItsFiles();

private:
    struct Outcome {
        int code = -1;
        QByteArray out;
        QByteArray error;
    };
    /// @p takesNothing: every file that the program writes is limited to a length of 0.
    Outcome run(const QStringList& arguments, const QProcessEnvironment& environment = withoutDisplay(),
                bool takesNothing = false);
    /// Runs the program, and fails the test unless it succeeds without any output.
    void runWell(const QStringList& arguments);
    static QProcessEnvironment withoutDisplay();
    QString path(const QString& name) const { return m_folder->filePath(name); }
    QByteArray read(const QString& name) const;
    void write(const QString& name, const QByteArray& content) const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

constexpr const char* kRecipe = R"({
    "espalier-recipe": 1, "name": "Test", "seed": 9,
    "operations": [
        {"op": "brushStroke", "samples": [[0, 0, 0.1, 0, 0.3], [1.5, 0.2, 1.5, 0, 0.5], [2.5, 0.8, 2.0, 0.2, 0.6]]},
        {"op": "grow", "steps": 3},
        {"op": "undo", "count": 1},
        {"op": "redo", "count": 1}
    ]})";

/// Two of its operations find nothing to do.
constexpr const char* kFutileRecipe = R"({
    "espalier-recipe": 1,
    "operations": [
        {"op": "grow", "steps": 1},
        {"op": "prune", "internodes": [71200]},
        {"op": "grow", "steps": 1},
        {"op": "removeLasso"}
    ]})";

} // namespace

void ProgramTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    write(QStringLiteral("r.json"), kRecipe);
}

QProcessEnvironment ProgramTest::withoutDisplay()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QString::fromLatin1(name));
    return environment;
}

ProgramTest::Outcome ProgramTest::run(const QStringList& arguments, const QProcessEnvironment& environment,
                                      bool takesNothing)
{
    QProcess process;
    if (takesNothing) {
        process.setChildProcessModifier([] {
            const rlimit nothing = {0, RLIM_INFINITY};
            ::setrlimit(RLIMIT_FSIZE, &nothing);
            // Writing fails then, instead of ending the program.
            std::signal(SIGXFSZ, SIG_IGN);
        });
    }
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(m_folder->path());
    process.start(QCoreApplication::applicationDirPath() + QStringLiteral("/espalier"), arguments);
    if (!process.waitForFinished(200'000)) {
        process.kill();
        process.waitForFinished();
        return {};
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

void ProgramTest::runWell(const QStringList& arguments)
{
    const Outcome outcome = run(arguments);
    QVERIFY2(outcome.code == 0, outcome.error.constData());
    QVERIFY2(outcome.out.isEmpty(), outcome.out.constData());
    QVERIFY2(outcome.error.isEmpty(), outcome.error.constData());
}

QByteArray ProgramTest::read(const QString& name) const
{
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void ProgramTest::write(const QString& name, const QByteArray& content) const
{
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

void ProgramTest::chosenLanguage_isSpoken()
{
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("Espalier")));
    QProcessEnvironment environment = withoutDisplay();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_folder->path());
    const QByteArray english = run({"replay", "none.json"}, environment).error;
    write(QStringLiteral("Espalier/espalier.conf"), "[window]\nlanguage=de\n");
    const Outcome german = run({"replay", "none.json"}, environment);
    QCOMPARE(german.code, 3);
    QVERIFY2(german.error.contains("none.json") && german.error != english, german.error.constData());
}

void ProgramTest::replay_writesEveryOutputAndNothingElse()
{
    runWell(
        {"replay", "r.json", "-o", "t.espalier", "-o", "t.obj", "-o", "t.fbx", "-o", "t.glb", "-o", "t.csv"});
    QVERIFY(read("t.espalier").startsWith("PK"));
    QVERIFY(read("t.obj").contains("mtllib"));
    QVERIFY(read("t.fbx").startsWith("Kaydara FBX Binary"));
    QVERIFY(read("t.glb").startsWith("glTF"));
    QVERIFY(read("t.csv").startsWith("id,parent,x0,y0,z0,x1,y1,z1,radius\n"));
    for (const QString& name : QDir(m_folder->path()).entryList(QDir::Files)) {
        const bool expected = name == QStringLiteral("r.json") || name.startsWith(QStringLiteral("t."));
        QVERIFY2(expected || name.endsWith(QStringLiteral(".png")), qPrintable(name));
    }
}

void ProgramTest::replay_continuesOneTreeThroughSeveralRecipes()
{
    write("more.json", R"({"espalier-recipe": 1, "seed": 77, "operations": [{"op": "grow", "steps": 2}]})");
    runWell({"replay", "r.json", "-o", "one.espalier", "--stats", "one.stats"});
    runWell({"replay", "r.json", "more.json", "-o", "two.espalier", "--stats", "two.stats"});
    const auto steps = [this](const char* name) {
        return QJsonDocument::fromJson(read(QString::fromLatin1(name)))
            .object()[QStringLiteral("steps")]
            .toInt();
    };
    QCOMPARE(steps("two.stats"), steps("one.stats") + 2);
    const QJsonObject two = QJsonDocument::fromJson(run({"info", "two.espalier"}).out).object();
    QCOMPARE(two[QStringLiteral("seed")].toString(), QStringLiteral("9"));
}

void ProgramTest::replay_takesTheSeedOfTheCommandLine()
{
    runWell({"replay", "r.json", "-o", "a.csv"});
    runWell({"replay", "r.json", "--seed", "9", "-o", "b.csv"});
    runWell({"replay", "r.json", "--seed", "10", "-o", "c.csv"});
    QCOMPARE(read("a.csv"), read("b.csv"));
    QVERIFY(read("a.csv") != read("c.csv"));
}

void ProgramTest::replay_takesParametersOfTheCommandLine()
{
    const auto recipeWith = [](const QByteArray& first, const QByteArray& later) {
        return "{\"espalier-recipe\": 1, \"parameters\": {\"growth\": {" + first +
               "}}, \"operations\": [{\"op\": \"grow\", \"steps\": 3}, {\"op\": \"setParameters\", "
               "\"parameters\": {\"growth\": {\"shedding\": 0.01" +
               later + "}}}, {\"op\": \"grow\", \"steps\": 3}]}";
    };
    write("plain.json", recipeWith("\"maxShootLength\": 3", ", \"maxShootLength\": 6"));
    write("wanted.json", recipeWith("\"maxShootLength\": 4", ""));
    runWell({"replay", "wanted.json", "-o", "a.csv"});
    runWell({"replay", "plain.json", "--set", "growth.maxShootLength=4", "-o", "b.csv"});
    runWell({"replay", "plain.json", "-o", "c.csv"});
    QCOMPARE(read("b.csv"), read("a.csv"));
    QVERIFY(read("c.csv") != read("a.csv"));
    // The history of a project as well, which then gives another tree without a warning.
    runWell({"replay", "plain.json", "-o", "plain.espalier"});
    runWell({"replay", "plain.espalier", "--strict", "--set", "growth.maxShootLength=4", "-o", "d.csv"});
    QCOMPARE(read("d.csv"), read("a.csv"));
}

void ProgramTest::vary_makesOtherTreesOfTheSameKind()
{
    runWell({"replay", "r.json", "-o", "t.espalier", "-o", "t.csv"});
    const QByteArray before = read("t.espalier");
    for (const char* number : {"1", "2"})
        runWell({"export", "t.espalier", "--vary", number, "-o", QByteArray("t-") + number + ".csv"});
    QVERIFY(read("t-1.csv") != read("t.csv"));
    QVERIFY(read("t-1.csv") != read("t-2.csv"));
    QCOMPARE(read("t-1.csv").count('\n'), read("t.csv").count('\n'));
    QCOMPARE(read("t.espalier"), before);
    // The same variation of the recipe's tree, which a project keeps as a step.
    runWell({"replay", "r.json", "--vary", "2:0.3", "-o", "v.csv", "-o", "v.espalier"});
    QCOMPARE(read("v.csv"), read("t-2.csv"));
    runWell({"replay", "v.espalier", "--strict", "-o", "again.csv"});
    QCOMPARE(read("again.csv"), read("v.csv"));
}

void ProgramTest::exportAndRender_takeParametersForTheirOutputAlone()
{
    runWell({"replay", "r.json", "-o", "t.espalier", "-o", "t.csv"});
    const QByteArray before = read("t.espalier");
    runWell({"export", "t.espalier", "-o", "thick.csv", "-o", "thick.espalier", "--set",
             "widths.tipDiameter=0.02", "--set", "leaves.visible=false"});
    QVERIFY(read("thick.csv") != read("t.csv"));
    QCOMPARE(read("t.espalier"), before);
    const QJsonObject info = QJsonDocument::fromJson(run({"info", "thick.espalier"}).out).object();
    const QJsonObject parameters = info[QStringLiteral("parameters")].toObject();
    QCOMPARE(parameters[QStringLiteral("widths")][QStringLiteral("tipDiameter")].toDouble(), 0.02);
    QCOMPARE(parameters[QStringLiteral("leaves")][QStringLiteral("visible")], QJsonValue(false));
    // The values that a project has already change nothing.
    runWell({"export", "t.espalier", "-o", "same.csv", "--set", "widths.exponent=2.2"});
    QCOMPARE(read("same.csv"), read("t.csv"));

    QVERIFY2(!qEnvironmentVariableIsEmpty("DISPLAY"), "There is no display: run this test with xvfb-run -a.");
    QProcessEnvironment display = QProcessEnvironment::systemEnvironment();
    display.remove(QStringLiteral("QT_QPA_PLATFORM"));
    const auto picture = [&](const QStringList& more) {
        const Outcome outcome =
            run(QStringList{"render", "t.espalier", "--png", "p.png", "--size", "200x200"} + more, display);
        return outcome.code == 0 ? QImage(path(QStringLiteral("p.png"))) : QImage();
    };
    const QImage leafy = picture({});
    const QImage bare = picture({"--set", "leaves.visible=false"});
    QVERIFY(!leafy.isNull() && !bare.isNull());
    QVERIFY(leafy != bare);
    QCOMPARE(read("t.espalier"), before);
}

void ProgramTest::replayOfAProject_givesTheSameProject()
{
    write("shape.json", R"({"espalier-recipe": 1, "operations": [
        {"op": "prune", "internodes": [30]},
        {"op": "bend", "base": 0, "handles": [{"internode": 9, "target": [0.5, 0.9, 0.1]}]},
        {"op": "setWidth", "internode": 1, "diameter": 0.1},
        {"op": "lasso", "points": [[-0.5, 1], [0.5, 1], [0.3, 2]], "steps": 3},
        {"op": "regrow"},
        {"op": "travel", "by": -2}]})");
    runWell({"replay", "r.json", "shape.json", "-o", "one.espalier"});
    runWell({"replay", "one.espalier", "--strict", "-o", "two.espalier", "-o", "two.glb"});
    QCOMPARE(read("two.espalier"), read("one.espalier"));
    // With another seed it is another tree of the same kind.
    QCOMPARE(run({"replay", "one.espalier", "--seed", "4", "-o", "three.espalier"}).code, 0);
    QVERIFY(read("three.espalier") != read("one.espalier"));
}

void ProgramTest::replayOfAnOldProject_saysWhichStepsAreNotKnown()
{
    const QString old = QStringLiteral(SOURCE_DIR "/tests/model/io/version1");
    const QStringList projects = QDir(old).entryList({QStringLiteral("*.espalier")});
    QVERIFY(!projects.isEmpty());
    const Outcome outcome = run({"replay", old + QLatin1Char('/') + projects.constFirst(), "-o", "t.csv"});
    QCOMPARE(outcome.code, 3);
    QVERIFY2(outcome.error.contains("did not record how") && outcome.error.contains("(1–"),
             outcome.error.constData());
    QCOMPARE(outcome.error.count('\n'), 1);
    QVERIFY(!QFileInfo::exists(path(QStringLiteral("t.csv"))));
}

void ProgramTest::replayOfAProject_saysIfAnotherTreeComesOfIt()
{
    runWell({"replay", "r.json", "-o", "one.espalier"});
    espalier::test::ZipEntries entries = espalier::test::unpackEntries(read("one.espalier"));
    QByteArray& records = espalier::test::entry(entries, "journal/records.json");
    records.replace("\"steps\":3", "\"steps\":2");
    write("other.espalier", espalier::test::packEntries(entries));
    const Outcome outcome = run({"replay", "other.espalier", "-o", "t.csv"});
    QCOMPARE(outcome.code, 0);
    QCOMPARE(outcome.error,
             QByteArray("espalier: other.espalier: its history, played again, gives a different tree "
                        "from the one it holds\n"));
    QCOMPARE(run({"replay", "other.espalier", "--strict", "-o", "u.csv"}).code, 3);
    QVERIFY(!QFileInfo::exists(path(QStringLiteral("u.csv"))));
}

void ProgramTest::replay_namesWhatOperationsDoNotFind()
{
    write("fault.json", kFutileRecipe);
    const Outcome outcome = run({"replay", "r.json", "fault.json", "-o", "t.csv"});
    QCOMPARE(outcome.code, 0);
    QCOMPARE(outcome.error,
             QByteArray("espalier: fault.json: operations[1]: prune: there is no internode 71200\n"
                        "espalier: fault.json: operations[3]: removeLasso: there is no envelope\n"));
    QVERIFY(read("t.csv").size() > 100);
}

void ProgramTest::strictReplay_writesNothingIfAnOperationFindsNothing()
{
    write("fault.json", kFutileRecipe);
    const Outcome outcome =
        run({"replay", "r.json", "fault.json", "--strict", "-o", "t.csv", "--stats", "s.json"});
    QCOMPARE(outcome.code, 3);
    const QList<QByteArray> lines = outcome.error.trimmed().split('\n');
    QCOMPARE(lines.size(), 3);
    QVERIFY2(lines[0].endsWith("operations[1]: prune: there is no internode 71200"),
             outcome.error.constData());
    QVERIFY2(lines[2].contains("--strict"), outcome.error.constData());
    QVERIFY(!QFileInfo::exists(path(QStringLiteral("t.csv"))));
    QVERIFY(!QFileInfo::exists(path(QStringLiteral("s.json"))));
    runWell({"replay", "r.json", "--strict", "-o", "t.csv"});
    QVERIFY(QFileInfo::exists(path(QStringLiteral("t.csv"))));
}

void ProgramTest::replay_givesTheSameBytesOnOneThreadAndOnTwo_data()
{
    QTest::addColumn<QString>("recipe");
    const QDir samples(QStringLiteral(SOURCE_DIR "/resources/recipes"));
    // Brushed, grown alone, filled, and trained; test_samples undoes and redoes every sample.
    for (const char* name : {"oak.json", "spruce.json", "swan.json", "bonsai.json"})
        QTest::newRow(name) << samples.filePath(QLatin1String(name));
}

void ProgramTest::replay_givesTheSameBytesOnOneThreadAndOnTwo()
{
    QFETCH(QString, recipe);
    runWell({"replay", recipe, "--threads", "1", "-o", "one.espalier"});
    runWell({"replay", recipe, "--threads", "2", "-o", "two.espalier"});
    QVERIFY(read("one.espalier").size() > 1000);
    QVERIFY(read("one.espalier") == read("two.espalier"));
}

void ProgramTest::stats_haveTheirForm()
{
    runWell({"replay", "r.json", "-o", "t.glb", "--stats", "s.json"});
    const QJsonObject stats = QJsonDocument::fromJson(read("s.json")).object();
    const QStringList keys{"axes",         "buds",      "contacts",  "internodes", "leaves",
                           "leavesPlaced", "particles", "peakRssMb", "seconds",    "steps",
                           "strands",      "surface",   "triangles", "vertices"};
    QCOMPARE(stats.keys(), keys);
    // Tubes have no strands.
    const QStringList others{"seconds", "contacts", "surface", "strands", "particles", "leavesPlaced"};
    for (const QString& key : keys)
        QVERIFY2(others.contains(key) || stats[key].toDouble() > 0.0, qPrintable(key));
    QCOMPARE(stats[QStringLiteral("surface")].toObject()[QStringLiteral("openEdges")].toInt(-1), 0);
    runWell({"replay", "r.json", "--set", "wood.mesher=strands", "-o", "t.glb", "--stats", "strands.json"});
    const QJsonObject ofStrands = QJsonDocument::fromJson(read("strands.json")).object();
    for (const char* key : {"strands", "particles"})
        QVERIFY2(ofStrands[QLatin1String(key)].toDouble() > 0.0, key);
    const QJsonObject surface = ofStrands[QStringLiteral("surface")].toObject();
    for (const char* key : {"openEdges", "nonManifoldEdges", "nonManifoldVertices", "degenerate", "inverted"})
        QVERIFY2(surface[QLatin1String(key)].toInt(-1) == 0, key);
    QCOMPARE(surface[QStringLiteral("components")].toInt(), 1);
    const QJsonObject seconds = stats[QStringLiteral("seconds")].toObject();
    QCOMPARE(seconds.keys(), (QStringList{"export", "growth", "mesh", "profiles", "total", "wood"}));
    double sum = 0.0;
    for (const char* key : {"export", "growth", "mesh"})
        sum += seconds[QLatin1String(key)].toDouble();
    QVERIFY(sum > 0.0 && sum <= seconds[QStringLiteral("total")].toDouble());
}

void ProgramTest::exportedProject_equalsReplayedExports()
{
    runWell({"replay", "r.json", "-o", "t.espalier", "-o", "t.glb", "-o", "t.csv"});
    runWell({"export", "t.espalier", "-o", "again.glb", "-o", "again.csv", "-o", "again.espalier"});
    QVERIFY(read("t.csv") == read("again.csv"));
    QVERIFY(read("t.glb") == read("again.glb"));
    QVERIFY(read("t.espalier") == read("again.espalier"));
}

void ProgramTest::sketch_makesATreeOfADrawing()
{
    // A trunk from above, two branches, and a second drawing whose large loop is a crown.
    write(QStringLiteral("d.ndjson"),
          "{\"drawing\":[[[50,50],[20,100]],[[50,90,95],[60,40,20]],[[10,48],[30,70]]]}\n"
          "{\"drawing\":[[[50,50],[60,120]],[[50,90,95,50,5,10,48],[60,55,20,0,20,55,60]]]}\n");
    const Outcome outcome =
        run({"sketch", "d.ndjson", "--stats", "s.json", "-o", "t.espalier"}, withoutDisplay());
    QCOMPARE(outcome.code, 0);
    const QJsonObject stats = QJsonDocument::fromJson(read(QStringLiteral("s.json"))).object();
    QCOMPARE(stats[QStringLiteral("strokes")].toInt(), 3);
    QCOMPARE(stats[QStringLiteral("attached")].toInt(), 3);
    QVERIFY(stats[QStringLiteral("frontError")].toDouble(9.0) < 1.0);
    QVERIFY(stats[QStringLiteral("sideOverFront")].toDouble() > 0.5);
    QVERIFY(stats[QStringLiteral("seconds")].toObject()[QStringLiteral("infer")].toDouble() > 0.0);
    QCOMPARE(stats[QStringLiteral("axes")].toInt(), 5);
    QCOMPARE(run({"sketch", "d.ndjson", "--front-only", "--stats", "s.json"}).code, 0);
    QCOMPARE(QJsonDocument::fromJson(read(QStringLiteral("s.json"))).object()[QStringLiteral("axes")].toInt(),
             3);
    QCOMPARE(run({"sketch", "d.ndjson", "--index", "1", "--stats", "s.json"}).code, 0);
    const QJsonObject crown = QJsonDocument::fromJson(read(QStringLiteral("s.json"))).object();
    QCOMPARE(crown[QStringLiteral("crowns")].toInt(), 1);
    QVERIFY(crown[QStringLiteral("internodes")].toInt() > 100);
    const Outcome none = run({"sketch", "d.ndjson", "--index", "7"});
    QCOMPARE(none.code, 3);
    QVERIFY(none.error.contains("d.ndjson: it has no drawing 7"));
}

void ProgramTest::info_describesAProject()
{
    runWell({"replay", "r.json", "-o", "t.espalier", "--stats", "s.json"});
    const Outcome outcome = run({"info", "t.espalier"});
    QCOMPARE(outcome.code, 0);
    QVERIFY(outcome.error.isEmpty());
    const QJsonObject info = QJsonDocument::fromJson(outcome.out).object();
    const QJsonObject stats = QJsonDocument::fromJson(read("s.json")).object();
    QCOMPARE(info[QStringLiteral("version")].toInt(), 2);
    const QJsonObject counts = info[QStringLiteral("counts")].toObject();
    for (const char* key : {"internodes", "buds", "leaves", "leavesPlaced", "axes", "steps"})
        QCOMPARE(counts[QLatin1String(key)], stats[QLatin1String(key)]);
    const QJsonObject bounds = info[QStringLiteral("bounds")].toObject();
    QVERIFY(bounds[QStringLiteral("maximum")].toArray().at(1).toDouble() > 1.0);
    QVERIFY(bounds[QStringLiteral("minimum")].toArray().at(0).toDouble() < 0.0);
    QVERIFY(info[QStringLiteral("journalLength")].toInt() > 3);
    QVERIFY(info[QStringLiteral("parameters")].toObject().contains(QStringLiteral("growth")));
}

void ProgramTest::helpAndVersion_goToStandardOutput()
{
    const Outcome help = run({"--help"});
    QCOMPARE(help.code, 0);
    for (const char* word :
         {"replay", "export", "render", "info", "--demo", "--threads", "--stats", "three-quarter"})
        QVERIFY2(help.out.contains(word), word);
    QVERIFY(help.error.isEmpty());
    const Outcome version = run({"--version"});
    QCOMPARE(version.code, 0);
    QCOMPARE(version.out, QByteArray("Espalier " ESPALIER_VERSION "\n"));
}

void ProgramTest::failures_areOneLineAndACode_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("mentions");
    const auto add = [](const char* name, const QStringList& arguments, int code, const char* mentions) {
        QTest::newRow(name) << arguments << code << QString::fromLatin1(mentions);
    };
    add("no recipe", {"replay"}, 2, "recipe");
    add("unknown option", {"replay", "r.json", "--fast"}, 2, "--fast");
    add("unknown format", {"replay", "r.json", "-o", "t.stl"}, 2, "t.stl");
    add("parameter without a value", {"replay", "r.json", "--set", "growth.shedding"}, 2, "group.name=value");
    add("unknown parameter", {"export", "t.espalier", "--set", "growth.x=1"}, 2, "growth.x");
    add("value out of range", {"render", "t.espalier", "--png", "p.png", "--set", "growth.shedding=7"}, 2,
        "growth.shedding");
    add("recipe is not there", {"replay", "none.json", "-o", "t.glb"}, 3, "none.json");
    add("recipe is a folder", {"replay", "folder"}, 3, "folder");
    add("recipe is no JSON", {"replay", "broken.json"}, 3, "broken.json");
    add("recipe has a fault", {"replay", "fault.json"}, 3, "operations[1].steps");
    add("second recipe has a fault", {"replay", "r.json", "fault.json"}, 3, "fault.json");
    add("project is not there", {"export", "none.espalier", "-o", "t.glb"}, 3, "none.espalier");
    add("project is a recipe", {"info", "r.json"}, 3, "r.json");
    add("project is empty", {"info", "empty.espalier"}, 3, "empty.espalier");
    add("project of none rendered", {"render", "none.espalier", "--png", "p.png"}, 4, "p.png");
    add("output has no folder", {"replay", "r.json", "-o", "no/where/t.glb"}, 4, "t.glb: ");
    add("project has no folder", {"replay", "r.json", "-o", "no/where/t.espalier"}, 4, "t.espalier: ");
    add("stats have no folder", {"replay", "r.json", "--stats", "no/where/s.json"}, 4, "s.json: the folder");
    add("picture without a display", {"replay", "r.json", "--png", "p.png"}, 4, "display");
    add("window without a display", {}, 4, "display");
}

void ProgramTest::failures_areOneLineAndACode()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QString, mentions);
    write("broken.json", "{\"espalier-recipe\": 1,\n oops}");
    write(
        "fault.json",
        R"({"espalier-recipe": 1, "operations": [{"op": "grow", "steps": 1}, {"op": "grow", "steps": -3}]})");
    write("empty.espalier", "");
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder")));

    const Outcome outcome = run(arguments);
    QVERIFY2(outcome.code == code, outcome.error.constData());
    QVERIFY2(outcome.error.contains(mentions.toUtf8()), outcome.error.constData());
    QVERIFY2(outcome.error.count('\n') == 1 && outcome.error.endsWith('\n'), outcome.error.constData());
    QVERIFY(outcome.out.isEmpty());
    for (const char* name : {"t.glb", "t.stl", "p.png"})
        QVERIFY(!QFileInfo::exists(path(QString::fromLatin1(name))));
}

void ProgramTest::failedOutput_leavesTheOldFile()
{
    write("t.glb", "old");
    QCOMPARE(run({"replay", "r.json", "-o", "no/where/t.csv", "-o", "t.glb"}).code, 4);
    QCOMPARE(read("t.glb"), QByteArray("old"));
}

void ProgramTest::failedOutput_leavesTheOthersOut()
{
    write("t.obj", "old");
    const QStringList before = QDir(m_folder->path()).entryList(QDir::Files);
    const Outcome outcome = run({"replay", "r.json", "-o", "t.obj", "-o", "t.fbx", "-o", "t.espalier",
                                 "--stats", "no/such/folder/t.json"});
    QVERIFY(outcome.code != 0);
    QCOMPARE(read("t.obj"), QByteArray("old"));
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), before);
}

void ProgramTest::texturesOfAnOutput_leaveTheOthersTheirNames()
{
    runWell(
        {"replay", "r.json", "-o", "oak.obj", "-o", "oak.obj", "-o", "oak.fbx", "--stats", "oak_bark.png"});
    QVERIFY(read("oak_bark.png").startsWith('{'));
    QVERIFY(read("oak.mtl").isEmpty());
    QVERIFY(read("oak_2.mtl").contains("oak_2_bark.png"));
    QVERIFY(read("oak_2_bark.png").startsWith("\x89PNG"));
    QVERIFY(read("oak.fbx").contains("oak_3_bark.png"));
    QVERIFY(read("oak_4_bark.png").isEmpty());
}

void ProgramTest::diskThatTakesNothing_leavesOldFilesAndFails_data()
{
    QTest::addColumn<QStringList>("options");
    for (const char* name : {"t.espalier", "t.obj", "t.fbx", "t.glb", "t.csv"})
        QTest::newRow(name) << QStringList{"-o", QString::fromLatin1(name)};
    QTest::newRow("--stats") << QStringList{"--stats", "t.stats"};
}

void ProgramTest::diskThatTakesNothing_leavesOldFilesAndFails()
{
    QFETCH(QStringList, options);
    write("few.json", R"({"espalier-recipe": 1, "operations": [{"op": "grow", "steps": 1}]})");
    write("more.json", R"({"espalier-recipe": 1, "operations": [{"op": "grow", "steps": 4}]})");
    runWell(QStringList{"replay", "few.json"} + options);
    const QStringList names = QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden);
    QMap<QString, QByteArray> before;
    for (const QString& name : names)
        before[name] = read(name);

    const Outcome outcome = run(QStringList{"replay", "more.json"} + options, withoutDisplay(), true);
    QCOMPARE(outcome.code, 4);
    QCOMPARE(outcome.error.count('\n'), 1);
    QVERIFY2(outcome.error.contains("the file is too large for this disk"), outcome.error.constData());
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden), names);
    for (const QString& name : names)
        QVERIFY2(read(name) == before[name], qPrintable(name));
}

void ProgramTest::fullDisk_isSaidInWords()
{
    const Outcome outcome = run({"replay", "r.json", "--stats", "/dev/full"});
    QCOMPARE(outcome.code, 4);
    QCOMPARE(outcome.error, QByteArray("espalier: full: the disk is full\n"));
}

void ProgramTest::growthWithoutEnd_stopsAtTheMemory()
{
    write(QStringLiteral("endless.json"),
          R"({"espalier-recipe": 1, "operations": [{"op": "grow", "steps": 10000}]})");
    QProcess process;
    process.setChildProcessModifier([] {
        const rlimit most = {900U << 20U, RLIM_INFINITY};
        ::setrlimit(RLIMIT_AS, &most);
    });
    process.setProcessEnvironment(withoutDisplay());
    process.setWorkingDirectory(m_folder->path());
    process.start(QCoreApplication::applicationDirPath() + QStringLiteral("/espalier"),
                  {QStringLiteral("replay"), QStringLiteral("endless.json"), QStringLiteral("-o"),
                   QStringLiteral("endless.csv")});
    QVERIFY(process.waitForFinished(200'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 0);
    const QByteArray error = process.readAllStandardError();
    QVERIFY2(error.contains("grow: growth stopped at") && error.contains("may not hold more"),
             error.constData());
    QVERIFY(read(QStringLiteral("endless.csv")).size() > 1'000'000);
}

void ProgramTest::argumentsThatAreNotText_areRefused()
{
    // QProcess would make text of it.
    QProcess process;
    process.setProcessEnvironment(withoutDisplay());
    process.setWorkingDirectory(m_folder->path());
    process.start(QStringLiteral("sh"),
                  {QStringLiteral("-c"), QStringLiteral("exec \"$0\" info \"$(printf 'a\\377.espalier')\""),
                   QCoreApplication::applicationDirPath() + QStringLiteral("/espalier")});
    QVERIFY(process.waitForFinished(200'000));
    QCOMPARE(process.exitCode(), 2);
    const QByteArray error = process.readAllStandardError();
    QVERIFY2(error.contains("is not valid UTF-8"), error.constData());
}

void ProgramTest::picture_isDrawnOnADisplay()
{
    QVERIFY2(!qEnvironmentVariableIsEmpty("DISPLAY"), "There is no display: run this test with xvfb-run -a.");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
    Outcome outcome = run(
        {"replay", "r.json", "-o", "t.espalier", "--png", "a.png", "--size", "320x240", "--camera", "side"},
        environment);
    QVERIFY2(outcome.code == 0, outcome.error.constData());
    QVERIFY(outcome.out.isEmpty());
    outcome =
        run({"render", "t.espalier", "--png", "b.png", "--size", "320x240", "--camera", "side"}, environment);
    QVERIFY2(outcome.code == 0, outcome.error.constData());
    const QImage replayed(path(QStringLiteral("a.png")));
    QCOMPARE(replayed.size(), QSize(320, 240));
    QCOMPARE(replayed, QImage(path(QStringLiteral("b.png"))));
    outcome = run(
        {"render", "t.espalier", "--png", "c.png", "--size", "320x240", "--camera", "front", "--transparent"},
        environment);
    const QImage alone(path(QStringLiteral("c.png")));
    QCOMPARE(alone.pixelColor(0, 0).alpha(), 0);
    QCOMPARE(alone.pixelColor(0, 239).alpha(), 0);
    int solid = 0;
    for (int y = 0; y < alone.height(); ++y) {
        for (int x = 0; x < alone.width(); ++x)
            solid += alone.pixelColor(x, y).alpha() == 255 ? 1 : 0;
    }
    QVERIFY(solid > 50);

    outcome = run({"render", "t.espalier", "--png", "no/where/d.png"}, environment);
    QCOMPARE(outcome.code, 4);
    QCOMPARE(outcome.error.count('\n'), 1);
}

void ProgramTest::demonstration_onAVirtualDisplay_writesItsFiles()
{
    QVERIFY2(!qEnvironmentVariableIsEmpty("DISPLAY"), "There is no display: run this test with xvfb-run -a.");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
    environment.insert(QStringLiteral("ESPALIER_VIRTUAL_DISPLAY"), QStringLiteral("1"));
    const Outcome outcome = run({"--demo", "r.json"}, environment);
    QVERIFY2(outcome.code == 0, outcome.error.constData());
    for (const char* suffix : {"espalier", "fbx", "obj", "glb", "png"}) {
        const QString name = QStringLiteral("first-tree.%1").arg(QLatin1String(suffix));
        QVERIFY2(QFileInfo(path(name)).size() > 1000, suffix);
        QVERIFY2(outcome.out.contains(name.toUtf8()), outcome.out.constData());
    }
}

static const espalier::test::TestClass<ProgramTest> programTest;

#include "ProgramTest.moc"

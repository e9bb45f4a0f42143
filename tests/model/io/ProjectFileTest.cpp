// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ProjectFile.h"

#include "tests/support/OwnImages.h"
#include "tests/support/SampleProject.h"
#include "tests/support/TestClasses.h"
#include "tests/support/ZipEntries.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>

namespace espalier::test {

namespace {

template <class T>
T numberAt(const QByteArray& column, qsizetype row)
{
    T value;
    std::memcpy(&value, column.constData() + row * static_cast<qsizetype>(sizeof(T)), sizeof(T));
    return value;
}

template <class T>
void setNumber(QByteArray& column, qsizetype row, T value)
{
    std::memcpy(column.data() + row * static_cast<qsizetype>(sizeof(T)), &value, sizeof(T));
}

QImage picture()
{
    QImage image(64, 48, QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            image.setPixel(x, y, qRgb(4 * x, 5 * y, 90));
    }
    return image;
}

/// A project with records: of an edit of two deltas, and of one of which nothing is known.
Project recordedProject()
{
    Project project = sampleProject(50);
    project.journal[0]->record =
        std::make_shared<const EditRecord>(EditRecord{R"({"op":"grow","steps":2})", 2});
    project.journal[2]->record = EditRecord::unknown();
    return project;
}

} // namespace

class ProjectFileTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void roundTrip_keepsTreeJournalNameAndThumbnail();
    void roundTrip_keepsASeedling();
    void roundTrip_keepsTheLargestSeed();
    void images_areKeptOnceEach();
    void missingOrWrongImages_showTheDrawnLook_data();
    void missingOrWrongImages_showTheDrawnLook();
    void withoutImages_nothingIsSaidOfThem();
    void look_isKeptWithItsPicture();
    void pictureThatIsALeafToo_isKeptOnce();
    void olderFiles_haveNoLook();
    void lostPicture_isSaid();
    void wrongLooks_areLeftOutAndSaid_data();
    void wrongLooks_areLeftOutAndSaid();
    void equalProjects_giveEqualBytes();
    void partsOfOtherPrograms_areKept();
    void deepMembers_areLeftOutAndSaid();
    void partsThatCannotBeKept_areLeftOutAndSaid_data();
    void partsThatCannotBeKept_areLeftOutAndSaid();
    void reloadedJournal_revertsToTheSeedlingAndComesBack();
    void saveAndLoad_goThroughAFile();
    void thumbnail_isReadAlone();
    void damagedThumbnail_doesNotKeepTheTreeFromOpening();
    void failedSave_leavesTheOldFile();
    void missingFile_saysSo();
    void newerVersion_isRefusedWithBothVersions();
    void wrongFiles_areRefused_data();
    void wrongFiles_areRefused();
    void wrongDescriptions_areRefused_data();
    void wrongDescriptions_areRefused();
    void wrongParameterSets_areRefused_data();
    void wrongParameterSets_areRefused();
    void unsoundProject_isNotWritten();
    void plainColumns_areLeftOutAndFilledIn();
    void wrongColumns_areRefused_data();
    void wrongColumns_areRefused();
    void records_areKept();
    void wrongRecords_areRefused_data();
    void wrongRecords_areRefused();
    void zipBomb_isRefusedBeforeItIsUnpacked();
    void halfAMillionInternodes_areSavedAndLoadedInSeconds();
};

void ProjectFileTest::roundTrip_keepsTreeJournalNameAndThumbnail()
{
    Project project = sampleProject(400);
    project.thumbnail = picture();
    QVERIFY(project.journal.size() > 10);
    QCOMPARE(project.tree.parameterSets().size(), 2);

    const Result<Project> back = unpackProject(*packProject(project));
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(back->tree == project.tree);
    QVERIFY(sameJournal(back->journal, project.journal));
    QCOMPARE(back->name, project.name);
    QCOMPARE(back->thumbnail.convertToFormat(QImage::Format_RGB32), project.thumbnail);
}

void ProjectFileTest::roundTrip_keepsASeedling()
{
    const Project project;
    const Result<Project> back = unpackProject(*packProject(project));
    QVERIFY(back);
    QVERIFY(back->tree == project.tree);
    QVERIFY(back->journal.empty());
    QVERIFY(back->thumbnail.isNull());
}

void ProjectFileTest::roundTrip_keepsTheLargestSeed()
{
    Project project;
    project.tree = Tree(std::numeric_limits<std::uint64_t>::max());
    QCOMPARE(unpackProject(*packProject(project))->tree.seed(), std::numeric_limits<std::uint64_t>::max());
}

namespace {

/// Two images in three parameter sets.
Project illustratedProject()
{
    Project project = sampleProject(60);
    TreeParameters parameters = project.tree.parameters();
    parameters.leaves.image = ImageAsset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("Älteste.png"));
    parameters.bark.image = ImageAsset(pngOf(repeatingBark(32, 32)), QStringLiteral("bark.png"));
    const auto change = [&] {
        auto delta = std::make_shared<TreeDelta>(parameterChange(project.tree, parameters));
        project.tree.apply(*delta);
        project.journal.push_back(delta);
    };
    change();
    parameters.bark.normalImage = parameters.bark.image;
    parameters.leaves.image = {};
    change();
    parameters.leaves.image = ImageAsset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("Älteste.png"));
    change();
    return project;
}

/// A look in which every value differs from the default.
SceneLook sampleLook()
{
    SceneLook look;
    look.groundShown = look.shadowsShown = look.sunShown = false;
    look.gridShown = look.sunPinned = true;
    look.backdrop = Backdrop::Gradient;
    look.backgroundColour = QColor(0x12, 0x34, 0x56);
    look.backgroundTop = QColor(0x65, 0x43, 0x21);
    look.sunAzimuth = radians(-77.7);
    look.sunElevation = 1.25;
    look.tracing = {.image = ImageAsset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("Älteste.png")),
                    .right = 0.1,
                    .up = -0.3,
                    .height = 2.5,
                    .opacity = 0.7};
    return look;
}

} // namespace

void ProjectFileTest::images_areKeptOnceEach()
{
    const Project project = illustratedProject();
    const QByteArray file = *packProject(project);
    QByteArrayList assets;
    for (const auto& [name, content] : unpackEntries(file)) {
        if (name.startsWith("assets/"))
            assets.append(content);
    }
    QCOMPARE(assets.size(), 2);
    QVERIFY(assets.contains(pngOf(drawnLeaf(Qt::transparent))));
    const Result<Project> back = unpackProject(file);
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QCOMPARE(back->warning, QString());
    QVERIFY(back->tree == project.tree);
    QCOMPARE(back->tree.parameters().leaves.image.name(), QStringLiteral("Älteste.png"));
    QCOMPARE(back->tree.parameters().leaves.image.pixels().size(), QSize(120, 200));
    QVERIFY(survivesItsHistory(*back));
    QCOMPARE(*packProject(*back), file);
}

void ProjectFileTest::missingOrWrongImages_showTheDrawnLook_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("missing") << QByteArray();
    QTest::newRow("other image") << pngOf(repeatingBark(16, 16));
    QTest::newRow("no image") << QByteArray("hello");
    QTest::newRow("nothing") << QByteArray("");
    QTest::newRow("cut off") << pngOf(drawnLeaf(Qt::transparent)).first(300);
}

void ProjectFileTest::missingOrWrongImages_showTheDrawnLook()
{
    QFETCH(const QByteArray, content);
    const Project project = illustratedProject();
    ZipEntries entries = unpackEntries(*packProject(project));
    const QByteArray name = "assets/" + project.tree.parameters().leaves.image.hash().toLatin1() + ".png";
    if (content.isNull())
        std::erase_if(entries, [&](const auto& e) { return e.first == name; });
    else
        entry(entries, name.constData()) = content;
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(back->tree.parameters().leaves.image.isNull());
    QVERIFY(back->tree.parameters().bark.image == project.tree.parameters().bark.image);
    QVERIFY(survivesItsHistory(*back));
    QCOMPARE(back->warning,
             QStringLiteral("the image “Älteste.png” is missing from it or broken; the built-in "
                            "look is shown instead"));

    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("oak.espalier")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(packEntries(entries));
    file.close();
    QVERIFY(loadProject(file.fileName())->warning.startsWith(QStringLiteral("oak.espalier: the image")));
}

void ProjectFileTest::withoutImages_nothingIsSaidOfThem()
{
    const ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    for (const auto& [name, content] : entries) {
        QVERIFY(!name.startsWith("assets/"));
        QVERIFY(name != "project.json" || !content.contains("mage"));
    }
}

void ProjectFileTest::look_isKeptWithItsPicture()
{
    Project project = sampleProject(50);
    project.look = sampleLook();
    const QByteArray file = *packProject(project);
    const Result<Project> back = unpackProject(file);
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(back->look == project.look);
    QCOMPARE(back->look->tracing.image.name(), QStringLiteral("Älteste.png"));
    QCOMPARE(back->look->tracing.image.file(), pngOf(drawnLeaf(Qt::transparent)));
    QVERIFY(back->tree == project.tree);
    QCOMPARE(back->warning, QString());
    QCOMPARE(*packProject(*back), file);
}

void ProjectFileTest::pictureThatIsALeafToo_isKeptOnce()
{
    Project project = illustratedProject();
    project.look = sampleLook();
    const ZipEntries entries = unpackEntries(*packProject(project));
    QCOMPARE(std::ranges::count_if(entries, [](const auto& e) { return e.first.startsWith("assets/"); }), 2);
}

void ProjectFileTest::olderFiles_haveNoLook()
{
    const ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    QVERIFY(std::ranges::none_of(entries, [](const auto& e) { return e.first == "look.json"; }));
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY(back && !back->look && back->warning.isEmpty());
}

void ProjectFileTest::lostPicture_isSaid()
{
    Project project = sampleProject(50);
    project.look = sampleLook();
    ZipEntries entries = unpackEntries(*packProject(project));
    std::erase_if(entries, [](const auto& e) { return e.first.startsWith("assets/"); });
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY(back && back->look);
    project.look->tracing.image = {};
    QVERIFY(back->look == project.look);
    QCOMPARE(back->warning,
             QStringLiteral("the reference picture “Älteste.png” is missing from it or broken"));
}

void ProjectFileTest::wrongLooks_areLeftOutAndSaid_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::newRow("no JSON") << QByteArray("{") << QByteArray("");
    QTest::newRow("unknown member") << QByteArray("\"ground\"") << QByteArray("\"floor\"");
    QTest::newRow("no switch") << QByteArray("\"grid\": true") << QByteArray("\"grid\": 1");
    QTest::newRow("no such backdrop") << QByteArray("gradient") << QByteArray("sunset");
    QTest::newRow("no colour") << QByteArray("#123456") << QByteArray("#12345g");
    QTest::newRow("another colour") << QByteArray("#123456") << QByteArray("red");
    QTest::newRow("below the horizon")
        << QByteArray("\"elevation\": 1.25") << QByteArray("\"elevation\": -1");
    QTest::newRow("too high") << QByteArray("\"height\": 2.5") << QByteArray("\"height\": 1e9");
}

void ProjectFileTest::wrongLooks_areLeftOutAndSaid()
{
    QFETCH(const QByteArray, from);
    QFETCH(const QByteArray, to);
    Project project = sampleProject(50);
    project.look = sampleLook();
    ZipEntries entries = unpackEntries(*packProject(project));
    QByteArray& look = entry(entries, "look.json");
    QVERIFY2(look.contains(from), look);
    look.replace(from, to);
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(!back->look);
    QVERIFY(back->tree == project.tree);
    QVERIFY2(back->warning.startsWith(QStringLiteral("its background and light cannot be read (look.json: ")),
             qPrintable(back->warning));
}

void ProjectFileTest::equalProjects_giveEqualBytes()
{
    Project first = sampleProject(300);
    Project second = sampleProject(300);
    first.thumbnail = second.thumbnail = picture();
    const QByteArray bytes = *packProject(first);
    QTest::qSleep(2100); // longer than the two seconds that a ZIP archive's clock ticks in
    QCOMPARE(*packProject(second), bytes);
    QCOMPARE(*packProject(*unpackProject(bytes)), bytes);
}

void ProjectFileTest::partsOfOtherPrograms_areKept()
{
    ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    QByteArray& description = entry(entries, "project.json");
    description.replace(0, 1, "{ \"shot\": {\"scene\": [7, \"forêt\"]},");
    entries.emplace_back("pipeline/notes.txt", QByteArray("Ready for review"));
    entries.emplace_back("approved", QByteArray());
    entries.emplace_back("mask.raw",
                         QByteArray(7 << 20, '\0')); // with what follows, as much as is always allowed
    const Result<Project> project = unpackProject(packEntries(entries));
    QVERIFY2(project, project ? "" : qPrintable(project.error().message));
    QCOMPARE(project->warning, QString());
    QCOMPARE(project->foreign.entries.size(), std::size_t{3});

    Project more = *project;
    more.foreign.entries.push_back({"zeros", QByteArray(24 << 20, '\0')});
    QVERIFY(unpackProject(*packProject(more)));
    const QByteArray bytes = *packProject(*project);
    const Result<Project> back = unpackProject(bytes);
    QVERIFY(back);
    QVERIFY(back->foreign == project->foreign);
    ZipEntries kept = unpackEntries(bytes);
    QCOMPARE(entry(kept, "pipeline/notes.txt"), QByteArray("Ready for review"));
    QVERIFY(entry(kept, "project.json").contains("forêt"));
}

void ProjectFileTest::partsThatCannotBeKept_areLeftOutAndSaid_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("above") << QByteArray("notes/../../notes");
    QTest::newRow("absolute") << QByteArray("/etc/notes");
    QTest::newRow("another system's folder") << QByteArray("..\\notes");
    QTest::newRow("long name") << QByteArray(300, 'n');
    QTest::newRow("control character") << QByteArray("no\nte");
    QTest::newRow("own name") << QByteArray("./project.json");
    QTest::newRow("drive") << QByteArray("C:/notes");
}

void ProjectFileTest::partsThatCannotBeKept_areLeftOutAndSaid()
{
    QFETCH(const QByteArray, name);
    const Project project = sampleProject(50);
    ZipEntries entries = unpackEntries(*packProject(project));
    entries.emplace_back(name, QByteArray("Ready for review"));
    entries.emplace_back("approved", QByteArray("yes"));
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(back->tree == project.tree);
    QCOMPARE(back->warning, QStringLiteral("some of what other programs have put into it cannot be kept"));
    QCOMPARE(back->foreign.entries.size(), std::size_t{1});
}

void ProjectFileTest::deepMembers_areLeftOutAndSaid()
{
    ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    const QByteArray deep = QByteArray(400, '[') + "7" + QByteArray(400, ']');
    entry(entries, "project.json").replace(0, 1, "{ \"shot\": " + deep + ",");
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QCOMPARE(back->warning, QStringLiteral("some of what other programs have put into it cannot be kept"));
    QVERIFY(back->foreign.members.isEmpty());
}

void ProjectFileTest::reloadedJournal_revertsToTheSeedlingAndComesBack()
{
    const Result<Project> project = unpackProject(*packProject(sampleProject(400)));
    QVERIFY(project);
    QVERIFY(survivesItsHistory(*project));
    Tree tree = project->tree;
    for (std::size_t i = project->journal.size(); i-- > 0;)
        tree.revert(*project->journal[i]);
    QCOMPARE(TreeIndex(tree).livingCount(), 1U);
    QCOMPARE(tree.step(), 0U);
}

void ProjectFileTest::saveAndLoad_goThroughAFile()
{
    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("tree.espalier"));
    const Project project = sampleProject(100);
    QVERIFY(saveProject(project, fileName));
    QVERIFY(saveProject(project, fileName)); // over the old one
    QVERIFY(loadProject(fileName)->tree == project.tree);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

void ProjectFileTest::thumbnail_isReadAlone()
{
    const QTemporaryDir folder;
    Project project = sampleProject(100);
    project.thumbnail = picture();
    // The thumbnail can be read from a file whose tree is damaged.
    ZipEntries entries = unpackEntries(*packProject(project));
    entry(entries, "internodes/parent").clear();
    QFile file(folder.filePath(QStringLiteral("tree.espalier")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(packEntries(entries));
    file.close();
    QCOMPARE(readThumbnail(file.fileName())->convertToFormat(QImage::Format_RGB32), project.thumbnail);
    QVERIFY(!readThumbnail(folder.filePath(QStringLiteral("none.espalier"))));
}

void ProjectFileTest::damagedThumbnail_doesNotKeepTheTreeFromOpening()
{
    Project project = sampleProject(100);
    project.thumbnail = picture();
    ZipEntries entries = unpackEntries(*packProject(project));
    entry(entries, "thumbnail.png").truncate(40);
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY(back);
    QVERIFY(back->tree == project.tree);
    QVERIFY(back->thumbnail.isNull());
}

void ProjectFileTest::failedSave_leavesTheOldFile()
{
    const QTemporaryDir folder;
    const Result<void> saved = saveProject({}, folder.filePath(QStringLiteral("none/tree.espalier")));
    QVERIFY(!saved);
    QCOMPARE(saved.error().kind, Error::Kind::Output);
    QVERIFY(saved.error().message.startsWith(QStringLiteral("tree.espalier: ")));

    const QString fileName = folder.filePath(QStringLiteral("tree.espalier"));
    QVERIFY(saveProject(sampleProject(50), fileName));
    Project tooLarge;
    for (std::uint32_t i = 0; i <= projectLimits::kDeltas; ++i)
        tooLarge.journal.push_back(i == 0 ? std::make_shared<TreeDelta>() : tooLarge.journal.front());
    QVERIFY(!saveProject(tooLarge, fileName));
    QVERIFY(loadProject(fileName));
}

void ProjectFileTest::missingFile_saysSo()
{
    const Result<Project> project = loadProject(QStringLiteral("/nowhere/tree.espalier"));
    QVERIFY(!project);
    QCOMPARE(project.error().kind, Error::Kind::Input);
    QVERIFY(project.error().message.startsWith(QStringLiteral("tree.espalier: ")));
}

void ProjectFileTest::newerVersion_isRefusedWithBothVersions()
{
    ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    QJsonObject json = QJsonDocument::fromJson(entry(entries, "project.json")).object();
    json[QStringLiteral("version")] = 7;
    json[QStringLiteral("program")] = QStringLiteral("9.9");
    json[QStringLiteral("fromTheFuture")] = true;
    entry(entries, "project.json") = QJsonDocument(json).toJson();
    const Result<Project> project = unpackProject(packEntries(entries));
    QVERIFY(!project);
    QCOMPARE(project.error().message,
             QStringLiteral(
                 "project.json: Espalier 9.9 wrote it in version 7 of the format; this is Espalier %1, which "
                 "reads versions up to 2")
                 .arg(QStringLiteral(ESPALIER_VERSION)));
}

void ProjectFileTest::wrongFiles_areRefused_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message");
    const QByteArray good = *packProject(sampleProject(50));
    QTest::newRow("empty") << QByteArray() << QStringLiteral("it is not a project file: it is empty");
    QTest::newRow("text") << QByteArray("hello")
                          << QStringLiteral("it is not a project file, or a damaged one");
    QTest::newRow("truncated") << good.left(good.size() / 2)
                               << QStringLiteral("it is not a project file, or a damaged one");
    QTest::newRow("other archive") << packEntries({{"mimetype", "text"}})
                                   << QStringLiteral("project.json: it is missing");
    QByteArray flipped = good;
    const qsizetype inside = flipped.indexOf("internodes/rotation") + 60;
    flipped[inside] = static_cast<char>(flipped[inside] ^ 0x10);
    QTest::newRow("bit flipped") << flipped << QStringLiteral("internodes/rotation: it is damaged");
    ZipEntries entries = unpackEntries(good);
    std::erase_if(entries, [](const auto& e) { return e.first == "journal/died"; });
    QTest::newRow("entry missing") << packEntries(entries) << QStringLiteral("journal/died: it is missing");
    entries = unpackEntries(good);
    entry(entries, "internodes/length").chop(1);
    QTest::newRow("column too short") << packEntries(entries) << QStringLiteral("internodes/length: it has ");
    entries = unpackEntries(good);
    entry(entries, "project.json").chop(10);
    QTest::newRow("JSON cut off") << packEntries(entries) << QStringLiteral("project.json: line ");
}

void ProjectFileTest::wrongFiles_areRefused()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, message);
    const Result<Project> project = unpackProject(content);
    QVERIFY(!project);
    QCOMPARE(project.error().kind, Error::Kind::Input);
    QVERIFY2(project.error().message.startsWith(message), qPrintable(project.error().message));
}

void ProjectFileTest::wrongDescriptions_areRefused_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QJsonValue>("value");
    QTest::addColumn<QString>("message");
    const QJsonValue absent(QJsonValue::Undefined);
    const auto row = [](const char* key, const QJsonValue& value, const char* message) {
        QTest::addRow("%s: %s", key, message)
            << QString::fromLatin1(key) << value
            << QStringLiteral("project.json: ") + QString::fromUtf8(message);
    };
    row("format", QStringLiteral("other"), "it does not describe an Espalier project");
    row("version", absent, "version: it is missing");
    row("step", -1, "step: a whole number from 0");
    row("seed", 1.5, "seed: a whole number of at most 64 bits");
    row("seed", QStringLiteral("18446744073709551616"), "seed: a whole number of at most 64 bits");
    row("internodes", 0, "internodes: a whole number from 1 to 20000000");
    row("internodes", 1e12, "internodes: a whole number from 1 to 20000000");
    row("leaves", -1, "leaves: a whole number from 0 to 20000000");
    row("deltas", 4'000'001, "deltas: a whole number from 0 to 4000000");
    row("ahead", 1'000'000, "ahead: a whole number from 0 to ");
    row("currentParameters", 70'000, "currentParameters: a whole number from 0 to 65535");
    row("lassosInForce", QJsonArray{-1}, "lassosInForce: indices of strokes");
    row("images", 5, "images: an object");
}

void ProjectFileTest::wrongDescriptions_areRefused()
{
    QFETCH(QString, key);
    QFETCH(QJsonValue, value);
    QFETCH(QString, message);
    ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    QJsonObject json = QJsonDocument::fromJson(entry(entries, "project.json")).object();
    if (value.isUndefined())
        json.remove(key);
    else
        json[key] = value;
    entry(entries, "project.json") = QJsonDocument(json).toJson();
    const Result<Project> project = unpackProject(packEntries(entries));
    QVERIFY(!project);
    QVERIFY2(project.error().message.startsWith(message), qPrintable(project.error().message));
}

void ProjectFileTest::wrongParameterSets_areRefused_data()
{
    QTest::addColumn<QJsonValue>("sets");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* title, const QJsonValue& sets, const char* message) {
        QTest::newRow(title) << sets << QStringLiteral("kept/parameters.json: ") + QString::fromUtf8(message);
    };
    row("none", QJsonArray(), "parameterSets: 1 to 65535 sets");
    row("numbers", QJsonArray{5, 5}, "parameterSets[0]: an object");
    row("unknown", QJsonArray{QJsonObject(), QJsonObject{{QStringLiteral("x"), 1}}},
        "parameterSets[1].x: there is no such parameter");
    row("no list", 5, "parameters: an array");
}

void ProjectFileTest::wrongParameterSets_areRefused()
{
    QFETCH(QJsonValue, sets);
    QFETCH(QString, message);
    ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    entry(entries, "kept/parameters.json") =
        QJsonDocument(QJsonObject{{QStringLiteral("parameters"), sets}}).toJson();
    const Result<Project> project = unpackProject(packEntries(entries));
    QVERIFY(!project);
    QVERIFY2(project.error().message.startsWith(message), qPrintable(project.error().message));
}

void ProjectFileTest::unsoundProject_isNotWritten()
{
    Project project = sampleProject(50);
    project.journal.back()->stepAfter += 1;
    const Result<QByteArray> packed = packProject(project);
    QVERIFY(!packed);
    QCOMPARE(packed.error().kind, Error::Kind::Output);
    QVERIFY2(packed.error().message.contains(QStringLiteral("its steps do not follow on")),
             qPrintable(packed.error().message));
}

void ProjectFileTest::plainColumns_areLeftOutAndFilledIn()
{
    const Project project = sampleProject(60);
    const ZipEntries entries = unpackEntries(*packProject(project));
    QVERIFY(std::ranges::none_of(entries, [](const auto& e) { return e.first == "internodes/along"; }));
    const Result<Project> back = unpackProject(packEntries(entries));
    QVERIFY(back);
    QVERIFY(back->tree.columns().along == QList<float>(60, 1.0F));
}

void ProjectFileTest::wrongColumns_areRefused_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message");
    const QByteArray good = *packProject(sampleProject(200));
    const auto row = [&](const char* title, const char* message,
                         const std::function<void(ZipEntries&)>& change) {
        ZipEntries entries = unpackEntries(good);
        change(entries);
        QTest::newRow(title) << packEntries(entries) << QString::fromUtf8(message);
    };
    row("parent behind", "internode 3: its parent",
        [](ZipEntries& e) { setNumber(entry(e, "internodes/parent"), 3, 9U); });
    row("not a number", "internode 4: its length", [](ZipEntries& e) {
        setNumber(entry(e, "internodes/length"), 4, std::numeric_limits<float>::quiet_NaN());
    });
    row("far away", "internode ", [](ZipEntries& e) {
        // A history changes the length of internode 1.
        for (qsizetype i = 2; i < 200; ++i)
            setNumber(entry(e, "internodes/length"), i, 999.0F);
    });
    row("steps torn", "step 3 of the history: its steps do not follow on",
        [](ZipEntries& e) { setNumber(entry(e, "journal/stepBefore"), 3, 2U); });
    row("steps backwards", "step 1 of the history: its steps do not follow on",
        [](ZipEntries& e) { setNumber(entry(e, "journal/stepBefore"), 0, 2U); });
    row("unknown parameters", "step 1 of the history: its parameters do not follow on",
        [](ZipEntries& e) { setNumber(entry(e, "journal/parametersBefore"), 0, 2U); });
    row("births overlap", "step ", [](ZipEntries& e) {
        QByteArray& count = entry(e, "journal/born");
        setNumber(count, 2, numberAt<std::uint32_t>(count, 2) + 1);
    });
    row("the seedling born", "step 1 of the history: its births are out of order", [](ZipEntries& e) {
        QByteArray& count = entry(e, "journal/born");
        setNumber(count, 0, numberAt<std::uint32_t>(count, 0) + 1);
    });
    row("births forgotten", "the beginning of the history: internode 1: it was born in the future",
        [](ZipEntries& e) { setNumber(entry(e, "journal/born"), 0, 0U); });
    row("born after its child", "step ", [](ZipEntries& e) {
        QByteArray& count = entry(e, "journal/born");
        setNumber(count, 2, numberAt<std::uint32_t>(count, 2) - 1);
    });
    row("birth too huge", "the history: its parts do not add up",
        [](ZipEntries& e) { setNumber(entry(e, "journal/born"), 1, 0xffffffffU); });
    row("deaths do not add up", "the history: its parts do not add up",
        [](ZipEntries& e) { setNumber(entry(e, "journal/died.count"), 0, 0xffffffffU); });
    row("the living die", "step ", [](ZipEntries& e) { setNumber(entry(e, "journal/died"), 0, 1U); });
    row("the unknown die", "step ",
        [](ZipEntries& e) { setNumber(entry(e, "journal/died"), 0, 0xffffffffU); });
    row("death at another time", "step ", [](ZipEntries& e) {
        const auto died = numberAt<InternodeId>(entry(e, "journal/died"), 0);
        QByteArray& death = entry(e, "internodes/death");
        setNumber(death, died, numberAt<Step>(death, died) + 1);
    });
    row("unknown buds", "step 1 of the history: it changes “buds” of a row that was not there",
        [](ZipEntries& e) { setNumber(entry(e, "journal/internodes.buds.row"), 0, 0xffffffffU); });
    row("impossible buds", "step 1 of the history: it changes “buds” in a way that is not possible",
        [](ZipEntries& e) { setNumber(entry(e, "journal/internodes.buds.before"), 0, std::uint32_t{0x40}); });
    row("other buds", "step 1 of the history: it changes “buds” in a way that is not possible",
        [](ZipEntries& e) { setNumber(entry(e, "journal/internodes.buds.after"), 0, std::uint32_t{0x03}); });
    row("what never changes", "step 1 of the history: it changes “parent”, which never changes",
        [](ZipEntries& e) {
            const auto size = entry(e, "journal/stepAfter").size();
            QByteArray count(size, '\0');
            setNumber(count, 0, 1U);
            e.emplace_back("journal/internodes.parent.count", count);
            for (const char* part : {".row", ".before", ".after"})
                e.emplace_back(QByteArray("journal/internodes.parent") + part, QByteArray(4, '\0'));
        });
    row("born at another time", "step ",
        [](ZipEntries& e) { setNumber(entry(e, "internodes/birth"), 1, 2U); });
}

void ProjectFileTest::wrongColumns_areRefused()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, message);
    const Result<Project> project = unpackProject(content);
    QVERIFY(!project);
    QVERIFY2(project.error().message.startsWith(message), qPrintable(project.error().message));
}

void ProjectFileTest::records_areKept()
{
    const Project project = recordedProject();
    const Result<Project> back = unpackProject(*packProject(project));
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(sameJournal(back->journal, project.journal));
    QCOMPARE(back->journal[0]->record->operation, QByteArray(R"({"op":"grow","steps":2})"));
    QCOMPARE(back->journal[0]->record->deltas, 2U);
    QVERIFY(!back->journal[1]->record);
    QVERIFY(back->journal[2]->record->operation.isEmpty());
    // Files of before have none.
    ZipEntries entries = unpackEntries(*packProject(project));
    std::erase_if(entries, [](const auto& e) { return e.first.startsWith("journal/records"); });
    const Result<Project> old = unpackProject(packEntries(entries));
    QVERIFY(old);
    QVERIFY(old->tree == project.tree);
    QVERIFY(std::ranges::none_of(old->journal, [](const auto& delta) { return delta->record != nullptr; }));
}

void ProjectFileTest::wrongRecords_areRefused_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message");
    const QByteArray json = "journal/records.json";
    const QString fault =
        QStringLiteral("step 1 of the history: the record of what was done is not a JSON object");
    QTest::newRow("an array") << json << QByteArray(R"(["op","growth","steps"])") << fault;
    QTest::newRow("no JSON") << json << QByteArray(23, '{') << fault;
    QTest::newRow("brackets that do not match")
        << json << QByteArray(R"({"op":)" + QByteArray(8, '[') + QByteArray(9, ']')) << fault;
    const QString parts = QStringLiteral("the record of what was done: its parts do not add up");
    QTest::newRow("too short") << json << QByteArray(R"({"op":"grow"})") << parts;
    QTest::newRow("too long") << json << QByteArray(R"({"op":"grow","steps":2} )") << parts;
    QTest::newRow("more edits than sizes") << QByteArray("journal/records.size") << QByteArray(4, '\1')
                                           << QStringLiteral("journal/records.size");
    QTest::newRow("huge size") << QByteArray("journal/records.size") << QByteArray(8, '\x7f') << parts;
    QTest::newRow("huge count") << QByteArray("journal/records.deltas") << QByteArray() << parts;
}

void ProjectFileTest::wrongRecords_areRefused()
{
    QFETCH(const QByteArray, name);
    QFETCH(const QByteArray, content);
    QFETCH(const QString, message);
    ZipEntries entries = unpackEntries(*packProject(recordedProject()));
    QByteArray& changed = entry(entries, name);
    if (content.isEmpty())
        std::fill(changed.begin(), changed.begin() + 4, '\x7f');
    else
        changed = content;
    const Result<Project> project = unpackProject(packEntries(entries));
    QVERIFY(!project);
    QVERIFY2(project.error().message.contains(message), qPrintable(project.error().message));
}

void ProjectFileTest::zipBomb_isRefusedBeforeItIsUnpacked()
{
    // 320 MB of zeros pack into 1.4 MB; the description declares less.
    ZipEntries entries = unpackEntries(*packProject(sampleProject(50)));
    entry(entries, "internodes/rotation") = QByteArray(320'000'000, '\0');
    const QByteArray bomb = packEntries(entries);
    QVERIFY(bomb.size() < 4'000'000);
    const Result<Project> project = unpackProject(bomb);
    QVERIFY(!project);
    QCOMPARE(project.error().message, QStringLiteral("it claims to hold far more than its size allows"));
    // A smaller one, in a file that could hold as much.
    entry(entries, "internodes/rotation") = QByteArray(6'000'000, '\0');
    const Result<Project> smaller = unpackProject(packEntries(entries));
    QVERIFY(!smaller);
    QVERIFY2(smaller.error().message.startsWith(QStringLiteral("internodes/rotation: it has 6000000 bytes")),
             qPrintable(smaller.error().message));

    // A declared size that the packed bytes cannot hold.
    QByteArray lie = *packProject(sampleProject(50));
    const qsizetype central = lie.indexOf("internodes/rotation", lie.indexOf("PK\x01\x02")) - 46;
    const std::uint32_t huge = 0x7fffffff;
    std::memcpy(lie.data() + central + 24, &huge, 4);
    QVERIFY(!unpackProject(lie));
}

void ProjectFileTest::halfAMillionInternodes_areSavedAndLoadedInSeconds()
{
    TreeBuilder builder;
    while (builder.tree.size() < 500'000) {
        std::vector<NewInternode> internodes;
        const std::uint32_t begin = builder.tree.size();
        for (std::uint32_t i = 0; i < 10'000; ++i) {
            internodes.push_back({.parent = i % 100 == 0 ? 0 : begin + i - 1,
                                  .slot = i % 100 == 0 ? 1 : kTerminalSlot,
                                  .rotation = continuing(0.001 * i, 0.002 * i),
                                  .length = 0.01F + 1e-6F * static_cast<float>(i)});
        }
        TreeDelta delta = births(builder.tree, internodes);
        // Many of them grow from the same bud in the same step.
        for (std::uint32_t i = 0; i < 10'000; ++i)
            delta.rows->internodes.key[i] = mixedBits((std::uint64_t{1} << 40U) + begin + i);
        builder.apply(std::move(delta));
    }
    Project large;
    large.tree = builder.tree;
    for (TreeDelta& delta : builder.journal)
        large.journal.push_back(std::make_shared<TreeDelta>(std::move(delta)));

    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("large.espalier"));
    QElapsedTimer timer;
    timer.start();
    const Result<void> written = saveProject(large, fileName);
    QVERIFY2(written, written ? "" : qPrintable(written.error().message));
    const qint64 saved = timer.restart();
    const Result<Project> back = loadProject(fileName);
    const qint64 loaded = timer.elapsed();
    QVERIFY2(back, back ? "" : qPrintable(back.error().message));
    QVERIFY(back->tree == large.tree);
    qInfo("saved in %lld ms, loaded in %lld ms, %lld bytes", saved, loaded, QFileInfo(fileName).size());
    QVERIFY(saved < 5000);
    QVERIFY(loaded < 5000);
}

static const TestClass<ProjectFileTest> projectFileTest;

} // namespace espalier::test

#include "ProjectFileTest.moc"

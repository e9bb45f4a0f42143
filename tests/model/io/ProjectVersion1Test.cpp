// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/Exporter.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/SampleProject.h"
#include "tests/support/TestClasses.h"
#include "tests/support/ZipEntries.h"

#include <QCryptographicHash>
#include <QTemporaryDir>
#include <QTest>

namespace espalier::test {

/// Files that a program of version 1 wrote can always be opened, and show the same tree.
class ProjectVersion1Test : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oldFile_opensAndIsTheSameTree_data();
    void oldFile_opensAndIsTheSameTree();
    void undoneRows_areGone();
    void earlierMoment_isShown();
    void image_isKept();
    void damagedOldFile_isRefused_data();
    void damagedOldFile_isRefused();
};

namespace {

QString pathOf(const QString& name)
{
    return QStringLiteral(SOURCE_DIR "/tests/model/io/version1/%1").arg(name);
}

QByteArray contentOf(const QString& name)
{
    QFile file(pathOf(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s is missing", qPrintable(file.fileName()));
    return file.readAll();
}

/// Hash of the places of all living internodes, as places.txt has it, and their number.
std::pair<int, QByteArray> placesOf(const Tree& tree)
{
    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("tree.csv"));
    if (const Result<void> exported = exportTree(tree, TreeIndex(tree), QStringLiteral("tree"), fileName);
        !exported)
        qFatal("%s", qPrintable(exported.error().message));
    QFile file(fileName);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no table");
    file.readLine();
    QCryptographicHash hash(QCryptographicHash::Sha256);
    int rows = 0;
    for (; !file.atEnd(); ++rows)
        hash.addData(file.readLine().split(',').mid(2, 6).join(',') + '\n');
    return {rows, hash.result().toHex()};
}

} // namespace

void ProjectVersion1Test::oldFile_opensAndIsTheSameTree_data()
{
    QTest::addColumn<int>("internodes");
    QTest::addColumn<QByteArray>("places");
    for (const QByteArray& line : contentOf(QStringLiteral("places.txt")).split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        if (words.size() == 3 && !line.startsWith('#'))
            QTest::newRow(words[0].constData()) << words[1].toInt() << words[2];
    }
}

void ProjectVersion1Test::oldFile_opensAndIsTheSameTree()
{
    QFETCH(const int, internodes);
    QFETCH(const QByteArray, places);
    const QString name = QString::fromLatin1(QTest::currentDataTag()) + QStringLiteral(".espalier");
    const Result<Project> project = loadProject(pathOf(name));
    QVERIFY2(project, project ? "" : qPrintable(project.error().message));
    QCOMPARE(project->warning, QString());
    const auto [rows, hash] = placesOf(shownTree(*project));
    QCOMPARE(rows, internodes);
    QCOMPARE(hash, places);
    QVERIFY(survivesItsHistory(*project));
    // Saved again, it is a file of the current version with the same content.
    const Result<QByteArray> packed = packProject(*project);
    QVERIFY2(packed, packed ? "" : qPrintable(packed.error().message));
    const Result<Project> again = unpackProject(*packed);
    QVERIFY2(again, again ? "" : qPrintable(again.error().message));
    QVERIFY(again->tree == project->tree);
    QVERIFY(sameJournal(again->journal, project->journal));
    QCOMPARE(again->ahead, project->ahead);
}

void ProjectVersion1Test::undoneRows_areGone()
{
    ZipEntries entries = unpackEntries(contentOf(QStringLiteral("kinds.espalier")));
    const qsizetype rows = entry(entries, "tree/present").size();
    const qsizetype absent = entry(entries, "tree/present").count('\0');
    QVERIFY(absent > 0);
    const Result<Project> project = loadProject(pathOf(QStringLiteral("kinds.espalier")));
    QVERIFY(project);
    QCOMPARE(static_cast<qsizetype>(project->tree.size()), rows - absent);
}

void ProjectVersion1Test::earlierMoment_isShown()
{
    const Result<Project> project = loadProject(pathOf(QStringLiteral("ahead.espalier")));
    QVERIFY(project);
    QCOMPARE(project->ahead, 3U);
    QVERIFY(shownTree(*project).step() < project->tree.step());
}

void ProjectVersion1Test::image_isKept()
{
    const Result<Project> project = loadProject(pathOf(QStringLiteral("image.espalier")));
    QVERIFY(project);
    QCOMPARE(project->tree.parameters().leaves.image.pixels().size(), QSize(16, 16));
}

void ProjectVersion1Test::damagedOldFile_isRefused_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message");
    const QByteArray huge(4, '\xff');
    const auto row = [](const char* name, const QByteArray& content, const char* message) {
        QTest::newRow(name) << QByteArray(name) << content << QString::fromLatin1(message);
    };
    ZipEntries entries = unpackEntries(contentOf(QStringLiteral("kinds.espalier")));
    const auto with = [&](const char* name, qsizetype place, const QByteArray& bytes) {
        QByteArray content = entry(entries, name);
        return content.replace(place, bytes.size(), bytes);
    };
    row("tree/parent", with("tree/parent", 40, QByteArray(4, '\x7f')), "internode 10: its parent");
    row("tree/length", entry(entries, "tree/length").chopped(1), "tree/length: it has ");
    row("journal/bornFirst", with("journal/bornFirst", 4, QByteArray(4, '\0')), "the history: ");
    row("journal/diedCount", with("journal/diedCount", 0, huge), "the history: ");
    row("journal/died", with("journal/died", 0, huge), "step ");
    row("journal/frameId", with("journal/frameId", 0, huge), "step ");
    row("lasso/pointCount", huge, "the lassos: ");
}

void ProjectVersion1Test::damagedOldFile_isRefused()
{
    QFETCH(const QByteArray, name);
    QFETCH(const QByteArray, content);
    QFETCH(const QString, message);
    ZipEntries entries = unpackEntries(contentOf(QStringLiteral("kinds.espalier")));
    entry(entries, name) = content;
    const Result<Project> project = unpackProject(packEntries(entries));
    QVERIFY(!project);
    QVERIFY2(project.error().message.startsWith(message), qPrintable(project.error().message));
}

const TestClass<ProjectVersion1Test> projectVersion1Test;

} // namespace espalier::test

#include "ProjectVersion1Test.moc"

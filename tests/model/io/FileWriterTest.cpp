// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/FileWriter.h"

#include "model/io/FileReader.h"
#include "model/io/export/Exporter.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/FaultyDisk.h"
#include "tests/support/SampleProject.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <sys/stat.h>

#include <cerrno>

namespace espalier::test {

namespace {

const QByteArray kOld = "what stood there before";

void put(const QString& fileName, const QByteArray& content)
{
    QFile file(fileName);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

QByteArray bytesOf(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
}

QMap<QString, QByteArray> allFilesIn(const QTemporaryDir& folder)
{
    QMap<QString, QByteArray> files;
    for (const QString& name : QDir(folder.path()).entryList(QDir::Files | QDir::Hidden))
        files[name] = bytesOf(folder.filePath(name));
    return files;
}

/// The smallest textures, so that there is little to write.
const ExportOptions kSmallExport{.textureSize = 64};

enum class Age { Old, New };

/// Writes one kind of output to "oak.<kind>"; old ones differ from new ones.
Result<void> writeKind(const QString& kind, const QTemporaryDir& folder, Age age)
{
    static const Project projects[] = {sampleProject(30), sampleProject(60)};
    const bool isNew = age == Age::New;
    const Project& project = projects[isNew ? 1 : 0];
    const QString fileName = folder.filePath(QStringLiteral("oak.") + kind);
    if (kind == QLatin1String("espalier"))
        return saveProject(project, fileName);
    if (kind == QLatin1String("small"))
        return writeFile(fileName, isNew ? "a few bytes" : "fewer");
    if (kind == QLatin1String("copy")) {
        const QTemporaryDir elsewhere;
        const QString source = elsewhere.filePath(QStringLiteral("source"));
        if (Result<void> written = writeFile(source, QByteArray(100'000, isNew ? 'n' : 'o')); !written)
            return written;
        return copyFile(source, fileName);
    }
    const Tree tree = shownTree(project);
    return exportTree(tree, TreeIndex(tree), QStringLiteral("Oak"), fileName, kSmallExport);
}

} // namespace

/// Files that are written whole or not at all.
class FileWriterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void writeFile_replacesTheFile();
    void permissions_areKept();
    void symbolicLink_staysAndItsTargetIsReplaced();
    void withoutCommit_theFileStaysAsItWas();
    void piecesOfAllSizes_areWrittenInOrder();
    void device_isWrittenToAndNotReplaced();
    void copyFile_copiesEveryByte();
    void fullDisk_isSaidInWords();
    void placesThatCannotBeWritten_areNamed_data();
    void placesThatCannotBeWritten_areNamed();
    void longestNames_canBeWritten();
    void oddNames_canBeWritten();
    void pipesAndLinksInACircle_areNamed();
    void filesThatBelongTogether_allStayIfOneFails();
    void appending_isWholeOrNothing();
    void filesOfAKilledProgram_areRemovedTheNextDay();
    void faultyDisk_leavesTheOldFilesOrTheNewOnes_data();
    void faultyDisk_leavesTheOldFilesOrTheNewOnes();
};

void FileWriterTest::writeFile_replacesTheFile()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("a.txt"));
    QVERIFY(writeFile(name, "one"));
    QVERIFY(writeFile(name, "three"));
    QCOMPARE(bytesOf(name), QByteArray("three"));
    QVERIFY(writeFile(name, {}));
    QCOMPARE(bytesOf(name), QByteArray());
    QCOMPARE(allFilesIn(folder).size(), 1);
}

void FileWriterTest::permissions_areKept()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("private.txt"));
    put(name, kOld);
    const QFile::Permissions permissions = QFile::ReadOwner | QFile::WriteOwner;
    QVERIFY(QFile::setPermissions(name, permissions));
    QVERIFY(writeFile(name, "new"));
    const QFile::Permissions others =
        QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    QCOMPARE(QFileInfo(name).permissions() & others, QFile::Permissions());
}

void FileWriterTest::symbolicLink_staysAndItsTargetIsReplaced()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("elsewhere")));
    const QString target = folder.filePath(QStringLiteral("elsewhere/target.txt"));
    const QString link = folder.filePath(QStringLiteral("link.txt"));
    put(target, kOld);
    QVERIFY(QFile::link(target, link));
    QVERIFY(writeFile(link, "new"));
    QVERIFY(QFileInfo(link).isSymLink());
    QCOMPARE(bytesOf(target), QByteArray("new"));
}

void FileWriterTest::withoutCommit_theFileStaysAsItWas()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("a.txt"));
    put(name, kOld);
    {
        FileWriter writer(name);
        writer.write(QByteArray(200'000, 'x'));
        QVERIFY(writer.finish());
        QCOMPARE(bytesOf(name), kOld);
    }
    QCOMPARE(allFilesIn(folder), (QMap<QString, QByteArray>{{QStringLiteral("a.txt"), kOld}}));
}

void FileWriterTest::piecesOfAllSizes_areWrittenInOrder()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("a.txt"));
    FileWriter writer(name);
    QByteArray expected;
    for (const int size : {0, 1, 65'535, 65'536, 65'537, 3, 1, 200'000, 7}) {
        const QByteArray piece(size, static_cast<char>('a' + expected.size() % 26));
        QCOMPARE(writer.write(piece), piece.size());
        expected += piece;
    }
    QVERIFY(writer.commit());
    QCOMPARE(bytesOf(name), expected);
}

void FileWriterTest::device_isWrittenToAndNotReplaced()
{
    QVERIFY(writeFile(QStringLiteral("/dev/null"), "nothing"));
    QVERIFY(!QFileInfo(QStringLiteral("/dev/null")).isFile());
}

void FileWriterTest::copyFile_copiesEveryByte()
{
    const QTemporaryDir folder;
    const QString from = folder.filePath(QStringLiteral("from"));
    const QString to = folder.filePath(QStringLiteral("to"));
    QByteArray bytes(300'001, 'b');
    bytes[299'999] = 'c';
    put(from, bytes);
    QVERIFY(copyFile(from, to));
    QCOMPARE(bytesOf(to), bytes);
    const Result<void> missing = copyFile(folder.filePath(QStringLiteral("none")), to);
    QVERIFY(!missing);
    QVERIFY2(missing.error().message.startsWith(QStringLiteral("none: ")),
             qPrintable(missing.error().message));
    QCOMPARE(bytesOf(to), bytes);
}

void FileWriterTest::fullDisk_isSaidInWords()
{
    for (const qsizetype size : {1, 1000, 1'000'000}) {
        const Result<void> written = writeFile(QStringLiteral("/dev/full"), QByteArray(size, 'x'));
        QVERIFY(!written);
        QCOMPARE(written.error().kind, Error::Kind::Output);
        QCOMPARE(written.error().message, QStringLiteral("full: the disk is full"));
    }
    for (const int number : {ENOSPC, EDQUOT, EROFS, EACCES, EFBIG, EIO, ENAMETOOLONG, EMFILE, ENODEV, 0}) {
        QVERIFY(!systemReason(number).isEmpty());
        QVERIFY2(!systemReason(number).contains(QStringLiteral("Unknown")), qPrintable(systemReason(number)));
    }
}

void FileWriterTest::placesThatCannotBeWritten_areNamed_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no folder") << QStringLiteral("none/a.txt") << QStringLiteral("none does not exist");
    QTest::newRow("a file as folder")
        << QStringLiteral("file/a.txt") << QStringLiteral("file is not a folder");
    QTest::newRow("a folder") << QStringLiteral("folder")
                              << QStringLiteral("a folder with this name already exists");
    QTest::newRow("no name") << QString() << QStringLiteral("a file needs a name");
    QTest::newRow("a long name") << QString(300, QLatin1Char('n')) << QStringLiteral("the name is too long");
}

void FileWriterTest::placesThatCannotBeWritten_areNamed()
{
    QFETCH(QString, name);
    QFETCH(QString, reason);
    const QTemporaryDir folder;
    put(folder.filePath(QStringLiteral("file")), kOld);
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("folder")));
    const Result<void> written = writeFile(name.isEmpty() ? name : folder.filePath(name), "text");
    QVERIFY(!written);
    QVERIFY2(written.error().message.contains(reason), qPrintable(written.error().message));
    QCOMPARE(allFilesIn(folder).size(), 1);
}

void FileWriterTest::longestNames_canBeWritten()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QString(251, QLatin1Char('n')) + QStringLiteral(".txt"));
    QVERIFY(writeFile(name, "one"));
    QVERIFY(writeFile(name, "two"));
    QCOMPARE(bytesOf(name), QByteArray("two"));
    const Result<void> longer = writeFile(name + QLatin1Char('x'), "three");
    QVERIFY(!longer);
    QVERIFY2(longer.error().message.endsWith(QStringLiteral("the name is too long")),
             qPrintable(longer.error().message));
}

void FileWriterTest::oddNames_canBeWritten()
{
    const QTemporaryDir folder;
    for (const char* name :
         {"eiche", "\u00c4lteste Eiche", "\u677e\u306e\u6728", "\u0434\u0443\u0431",
          "\u0634\u062c\u0631\u0629", "\U0001F333", " a b ", "-o", "a\nb", "a'b\"c", "%1%2", ".hidden"}) {
        const QString path = folder.filePath(QString::fromUtf8(name));
        QVERIFY2(writeFile(path, name), name);
        QCOMPARE(bytesOf(path), QByteArray(name));
    }
}

void FileWriterTest::pipesAndLinksInACircle_areNamed()
{
    const QTemporaryDir folder;
    const QString pipe = folder.filePath(QStringLiteral("pipe"));
    QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    const Result<void> piped = writeFile(pipe, "one");
    QVERIFY(!piped);
    QCOMPARE(piped.error().message, QStringLiteral("pipe: no program reads from this pipe"));

    const QString a = folder.filePath(QStringLiteral("a"));
    const QString b = folder.filePath(QStringLiteral("b"));
    QVERIFY(QFile::link(a, b) && QFile::link(b, a));
    const Result<void> circle = writeFile(a, "one");
    QVERIFY(!circle);
    QCOMPARE(circle.error().message, QStringLiteral("a: it is a link that leads back to itself"));

    for (const QString& name : {pipe, a, folder.path(), QStringLiteral("/dev/zero")}) {
        const Result<QByteArray> read = readFile(name, 1000);
        QVERIFY2(!read, qPrintable(name));
        QVERIFY(!loadProject(name));
    }
}

void FileWriterTest::filesThatBelongTogether_allStayIfOneFails()
{
    const QTemporaryDir folder;
    const QStringList names{folder.filePath(QStringLiteral("a")), folder.filePath(QStringLiteral("b")),
                            folder.filePath(QStringLiteral("c"))};
    put(names[0], kOld);
    put(names[2], kOld);
    const auto kPrivate = QFileDevice::ReadOwner | QFileDevice::WriteOwner;
    QVERIFY(QFile::setPermissions(names[0], kPrivate));
    const QMap<QString, QByteArray> before = allFilesIn(folder);
    const auto writeAll = [&names] {
        std::vector<std::unique_ptr<FileWriter>> writers;
        std::vector<FileWriter*> files;
        for (const QString& name : names) {
            writers.push_back(std::make_unique<FileWriter>(name));
            writers.back()->write("new");
            files.push_back(writers.back().get());
        }
        return FileWriter::commitAll(files);
    };
    // Each rename is the first that fails, once; where files have no second names, copies are renamed, too.
    for (const bool hasLinks : {true, false}) {
        for (int renames = 0; renames < (hasLinks ? 3 : 4); ++renames) {
            const FaultyDisk disk(folder.path(), FaultyDisk::Renames{renames, hasLinks}, EIO);
            const Result<void> written = writeAll();
            QVERIFY(!written);
            QVERIFY(written.error().message.endsWith(QStringLiteral("the disk reports an error")));
            QVERIFY2(!written.error().message.contains(QStringLiteral(".espalier")),
                     qPrintable(written.error().message));
            QCOMPARE(allFilesIn(folder), before);
            QCOMPARE(QFile::permissions(names[0]) & ~(QFileDevice::ReadUser | QFileDevice::WriteUser),
                     kPrivate);
        }
    }
    QVERIFY(writeAll());
    for (const QString& name : names)
        QCOMPARE(bytesOf(name), QByteArray("new"));
    QCOMPARE(allFilesIn(folder).size(), 3);
}

void FileWriterTest::appending_isWholeOrNothing()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("a"));
    QVERIFY(appendToFile(name, "one ", 0));
    {
        const FaultyDisk disk(folder.path(), 0, ENOSPC);
        const Result<void> full = appendToFile(name, "two ", 4);
        QVERIFY(!full);
        QCOMPARE(full.error().message, QStringLiteral("a: the disk is full"));
    }
    {
        // It is written, but cannot be brought to the disk.
        const FaultyDisk disk(folder.path(), 1, EIO);
        QVERIFY(!appendToFile(name, "three ", 4));
    }
    // Another program has written into it.
    QVERIFY(!appendToFile(name, "four", 9));
    QVERIFY(appendToFile(name, "four", 4));
    QCOMPARE(bytesOf(name), QByteArray("one four"));
}

void FileWriterTest::filesOfAKilledProgram_areRemovedTheNextDay()
{
    const QTemporaryDir folder;
    const QString abandoned = folder.filePath(QStringLiteral(".espalier-new-1"));
    const QString atWork = folder.filePath(QStringLiteral(".espalier-new-2"));
    const QString keptForASet = folder.filePath(QStringLiteral(".espalier-old-1"));
    const QString ofTheUser = folder.filePath(QStringLiteral("notes.txt"));
    for (const QString& name : {abandoned, atWork, keptForASet, ofTheUser}) {
        put(name, kOld);
        QFile file(name);
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QDateTime time = QDateTime::currentDateTime().addSecs(name == atWork ? -3600 : -100'000);
        QVERIFY(file.setFileTime(time, QFileDevice::FileModificationTime));
    }
    const QString tree = folder.filePath(QStringLiteral("tree"));
    QVERIFY(writeFile(tree, "a tree"));
    QVERIFY(!QFile::exists(abandoned));
    for (const QString& name : {atWork, keptForASet, ofTheUser, tree})
        QVERIFY2(QFile::exists(name), qPrintable(name));
}

void FileWriterTest::faultyDisk_leavesTheOldFilesOrTheNewOnes_data()
{
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"small", "copy", "espalier", "csv", "obj", "fbx", "glb"})
        QTest::newRow(kind) << QString::fromLatin1(kind);
}

void FileWriterTest::faultyDisk_leavesTheOldFilesOrTheNewOnes()
{
    QFETCH(QString, kind);
    const auto written = [&](Age age) {
        const QTemporaryDir folder;
        return writeKind(kind, folder, age) ? allFilesIn(folder) : QMap<QString, QByteArray>();
    };
    const QMap<QString, QByteArray> old = written(Age::Old);
    const QMap<QString, QByteArray> whole = written(Age::New);
    QVERIFY(!old.isEmpty());
    QCOMPARE(old.keys(), whole.keys());
    QVERIFY(old != whole);
    const QTemporaryDir folder;
    const auto putOld = [&] {
        for (const QString& name : old.keys())
            put(folder.filePath(name), old[name]);
    };
    putOld();
    int calls = 0;
    int callsBeforeNaming = 0;
    {
        const FaultyDisk good(folder.path(), FaultyDisk::kNever, 0);
        QVERIFY(writeKind(kind, folder, Age::New));
        calls = good.calls();
        callsBeforeNaming = good.callsBeforeNaming();
    }
    QCOMPARE(allFilesIn(folder), whole);
    QVERIFY2(callsBeforeNaming >= 2 * whole.size(), "each file is written and brought to the disk");
    for (int goodCalls = 0; goodCalls < calls; ++goodCalls) {
        putOld();
        Result<void> result;
        {
            const FaultyDisk disk(folder.path(), goodCalls, ENOSPC);
            result = writeKind(kind, folder, Age::New);
        }
        const QMap<QString, QByteArray> left = allFilesIn(folder);
        QVERIFY2(!result, qPrintable(QStringLiteral("call %1 failed unnoticed").arg(goodCalls)));
        QVERIFY2(result.error().message.endsWith(QStringLiteral(": the disk is full")),
                 qPrintable(result.error().message));
        QStringList names = left.keys();
        // What a dead disk does not let put back stays under another name.
        names.removeIf([](const QString& name) { return name.startsWith(QLatin1String(".espalier-")); });
        QCOMPARE(names, whole.keys());
        if (goodCalls < callsBeforeNaming)
            QCOMPARE(left, old);
        for (const QString& name : whole.keys())
            QVERIFY2(left[name] == old[name] || left[name] == whole[name],
                     qPrintable(QStringLiteral("%1 after %2 good calls").arg(name).arg(goodCalls)));
    }
}

static const TestClass<FileWriterTest> fileWriterTest;

} // namespace espalier::test

#include "FileWriterTest.moc"

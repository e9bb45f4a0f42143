// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/Exporter.h"
#include "model/io/export/FileMark.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QDir>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

namespace espalier::test {

namespace {

constexpr ExportOptions kSmallTextures{.textureSize = 64};

/// Content of a file; null if it cannot be read.
QByteArray bytesIn(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool putBytes(const QString& fileName, const QByteArray& content)
{
    QFile file(fileName);
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

using Contents = QHash<QString, QByteArray>;

Contents contentsOf(const QTemporaryDir& folder)
{
    Contents contents;
    for (const QString& name : QDir(folder.path()).entryList(QDir::Files | QDir::Hidden))
        contents[name] = bytesIn(folder.filePath(name));
    return contents;
}

/// Trees whose textures differ in every file.
TreeBuilder treeOf(BarkKind bark, LeafShape leaf)
{
    TreeParameters parameters;
    parameters.growth.lateralsPerNode = 2;
    parameters.bark.kind = bark;
    parameters.leaves.shape = leaf;
    return randomTree(20, 3, parameters);
}

Result<void> exportTo(const QTemporaryDir& folder, const QString& name, const TreeBuilder& builder)
{
    return exportTree(builder.tree, builder.index, QStringLiteral("Oak"), folder.filePath(name),
                      kSmallTextures);
}

/// Names of the PNG files that a model, or the .mtl that it names, refers to.
QSet<QString> texturesOf(const QTemporaryDir& folder, const QString& model)
{
    QByteArray content = bytesIn(folder.filePath(model));
    static const QRegularExpression materials(QStringLiteral("^mtllib (.*)$"),
                                              QRegularExpression::MultilineOption);
    if (model.endsWith(QLatin1String("obj"))) {
        const QString name = materials.match(QString::fromUtf8(content.first(400))).captured(1);
        content = bytesIn(folder.filePath(name));
    }
    static const QRegularExpression texture(QStringLiteral("[\\w-]+\\.png"));
    QSet<QString> names;
    for (QRegularExpressionMatchIterator i = texture.globalMatch(QString::fromLatin1(content)); i.hasNext();)
        names.insert(i.next().captured());
    return names;
}

} // namespace

class ExportFilesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fileOfThePersons_staysAndAnotherNameIsChosen_data();
    void fileOfThePersons_staysAndAnotherNameIsChosen();
    void textureThatWasChangedSince_stays();
    void folderOfTheName_isNoObstacle();
    void nextExport_replacesItsOwnFiles_data();
    void nextExport_replacesItsOwnFiles();
    void similarNames_shareNoFile_data();
    void similarNames_shareNoFile();
    void fileThatAppearsMeanwhile_stays();
    void longName_isShortened();
    void mark_isOfThisContentAndThisOwner_data();
    void mark_isOfThisContentAndThisOwner();
    void markedPng_isSound();
};

void ExportFilesTest::fileOfThePersons_staysAndAnotherNameIsChosen_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("own");
    for (const char* model : {"oak.obj", "oak.fbx"}) {
        for (const char* own : {"oak_bark.png", "oak_leaf_mask.png", "OAK_Bark.PNG", "oak.mtl"}) {
            if (QByteArray(own) != "oak.mtl" || QByteArray(model) == "oak.obj")
                QTest::addRow("%s beside %s", model, own)
                    << QString::fromUtf8(model) << QString::fromUtf8(own);
        }
    }
}

void ExportFilesTest::fileOfThePersons_staysAndAnotherNameIsChosen()
{
    QFETCH(const QString, model);
    QFETCH(const QString, own);
    const QTemporaryDir folder;
    const QByteArray picture = pngOf(repeatingBark(32, 32));
    QVERIFY(putBytes(folder.filePath(own), picture));
    const TreeBuilder tree = treeOf(BarkKind::Plated, LeafShape::Palmate);
    for (int round = 0; round < 2; ++round) {
        QVERIFY(exportTo(folder, model, tree));
        QCOMPARE(bytesIn(folder.filePath(own)), picture);
        const QSet<QString> textures = texturesOf(folder, model);
        QCOMPARE(textures.size(), 7);
        for (const QString& name : textures) {
            QVERIFY2(name.startsWith(QLatin1String("oak_2_")), qPrintable(name));
            QVERIFY(!QImage(folder.filePath(name)).isNull());
        }
        // The second round finds and replaces what the first has left.
        QCOMPARE(contentsOf(folder).size(), model.endsWith(QLatin1String("obj")) ? 10 : 9);
    }
}

void ExportFilesTest::textureThatWasChangedSince_stays()
{
    const QTemporaryDir folder;
    const TreeBuilder tree = treeOf(BarkKind::Plated, LeafShape::Palmate);
    QVERIFY(exportTo(folder, QStringLiteral("oak.obj"), tree));
    // The user paints on a texture; the paint program keeps the text chunks.
    const QString name = folder.filePath(QStringLiteral("oak_bark.png"));
    QImage image(name);
    image.setPixelColor(3, 3, Qt::red);
    QVERIFY(image.save(name));
    const QByteArray painted = bytesIn(name);
    QVERIFY(painted.contains("Espalier"));
    QVERIFY(exportTo(folder, QStringLiteral("oak.obj"), tree));
    QCOMPARE(bytesIn(name), painted);
    QVERIFY(texturesOf(folder, QStringLiteral("oak.obj")).contains(QStringLiteral("oak_2_bark.png")));
}

void ExportFilesTest::folderOfTheName_isNoObstacle()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("oak_bark.png")));
    QVERIFY(exportTo(folder, QStringLiteral("oak.obj"), treeOf(BarkKind::Plated, LeafShape::Palmate)));
    QVERIFY(texturesOf(folder, QStringLiteral("oak.obj")).contains(QStringLiteral("oak_2_bark.png")));
}

void ExportFilesTest::nextExport_replacesItsOwnFiles_data()
{
    QTest::addColumn<QString>("model");
    QTest::newRow("obj") << QStringLiteral("old oak.obj");
    QTest::newRow("fbx") << QStringLiteral("old oak.fbx");
}

void ExportFilesTest::nextExport_replacesItsOwnFiles()
{
    QFETCH(const QString, model);
    const QTemporaryDir folder;
    QVERIFY(exportTo(folder, model, treeOf(BarkKind::Plated, LeafShape::Palmate)));
    const Contents before = contentsOf(folder);
    QVERIFY(exportTo(folder, model, treeOf(BarkKind::Smooth, LeafShape::Lanceolate)));
    const Contents after = contentsOf(folder);
    QCOMPARE(QSet<QString>(after.keyBegin(), after.keyEnd()),
             QSet<QString>(before.keyBegin(), before.keyEnd()));
    for (const QString& name : texturesOf(folder, model))
        QVERIFY2(after[name] != before[name], qPrintable(name));
}

void ExportFilesTest::similarNames_shareNoFile_data()
{
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::newRow("a space") << QStringLiteral("my oak.obj") << QStringLiteral("my_oak.obj");
    QTest::newRow("two spaces") << QStringLiteral("my oak.fbx") << QStringLiteral("my  oak.fbx");
    QTest::newRow("case") << QStringLiteral("oak.obj") << QStringLiteral("Oak.obj");
    QTest::newRow("replaced letters") << QStringLiteral("oak#1.obj") << QStringLiteral("oak+1.obj");
    QTest::newRow("the format") << QStringLiteral("oak.fbx") << QStringLiteral("oak.obj");
    QTest::newRow("a number") << QStringLiteral("oak 2.fbx") << QStringLiteral("oak_2.fbx");
}

void ExportFilesTest::similarNames_shareNoFile()
{
    QFETCH(const QString, first);
    QFETCH(const QString, second);
    const QTemporaryDir folder;
    QVERIFY(exportTo(folder, first, treeOf(BarkKind::Plated, LeafShape::Palmate)));
    const Contents before = contentsOf(folder);
    QVERIFY(exportTo(folder, second, treeOf(BarkKind::Smooth, LeafShape::Lanceolate)));
    Contents after = contentsOf(folder);
    QCOMPARE(texturesOf(folder, first).size(), 7);
    QCOMPARE(texturesOf(folder, second).size(), 7);
    QVERIFY(!texturesOf(folder, first).intersects(texturesOf(folder, second)));
    for (auto file = before.begin(); file != before.end(); ++file)
        QVERIFY2(after[file.key()] == file.value(), qPrintable(file.key()));
    // The first finds its own files again.
    QVERIFY(exportTo(folder, first, treeOf(BarkKind::Plated, LeafShape::Palmate)));
    QVERIFY(contentsOf(folder) == after);
}

void ExportFilesTest::fileThatAppearsMeanwhile_stays()
{
    const QTemporaryDir folder;
    ExportFiles files(folder.filePath(QStringLiteral("oak.obj")));
    QVERIFY(files.chooseNames({QStringLiteral("_bark.png")}));
    QVERIFY(files.addCompanion(QStringLiteral("_bark.png"), pngOf(repeatingBark(32, 32))));
    QVERIFY(files.addMain(QByteArray("model")));
    QVERIFY(putBytes(folder.filePath(QStringLiteral("oak_bark.png")), "theirs"));
    const Result<void> committed = files.commit();
    QVERIFY(!committed);
    QVERIFY2(committed.error().message.startsWith(QStringLiteral("oak_bark.png: another program")),
             qPrintable(committed.error().message));
    QCOMPARE(bytesIn(folder.filePath(QStringLiteral("oak_bark.png"))), QByteArray("theirs"));
    QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("oak.obj"))));
}

void ExportFilesTest::longName_isShortened()
{
    const QTemporaryDir folder;
    const QString model = QString(240, u'o') + QStringLiteral(".obj");
    QVERIFY(exportTo(folder, model, treeOf(BarkKind::Plated, LeafShape::Palmate)));
    QCOMPARE(texturesOf(folder, model).size(), 7);
    const QString wide = QString(80, QChar(0x6728)) + QStringLiteral(".obj");
    QVERIFY(exportTo(folder, wide, treeOf(BarkKind::Plated, LeafShape::Palmate)));
}

void ExportFilesTest::mark_isOfThisContentAndThisOwner_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("png") << pngOf(repeatingBark(32, 32));
    QTest::newRow("text") << QByteArray("newmtl Oak\nKd 1 1 1\n");
    QTest::newRow("nothing") << QByteArray();
}

void ExportFilesTest::mark_isOfThisContentAndThisOwner()
{
    QFETCH(const QByteArray, content);
    const QString owner = QStringLiteral("Bäume.obj");
    const QByteArray file = marked(content, owner);
    QVERIFY(isMarked(file, owner));
    QVERIFY(!isMarked(content, owner));
    QVERIFY(!isMarked(file, QStringLiteral("Baume.obj")));
    for (qsizetype i = 0; i < file.size(); ++i) {
        QByteArray changed = file;
        changed[i] = static_cast<char>(changed[i] ^ 1);
        QVERIFY(!isMarked(changed, owner));
        QVERIFY(!isMarked(file.first(i), owner));
    }
    QVERIFY(!isMarked(file + '\n', owner));
}

void ExportFilesTest::markedPng_isSound()
{
    const QImage image = repeatingBark(32, 32).convertToFormat(QImage::Format_RGB888);
    const QImage read = QImage::fromData(marked(pngOf(image), QStringLiteral("oak.obj")), "png");
    QCOMPARE(read.convertToFormat(QImage::Format_RGB888), image);
    QCOMPARE(read.text(QStringLiteral("Espalier")).size(), 64);
}

static const TestClass<ExportFilesTest> exportFilesTest;

} // namespace espalier::test

#include "ExportFilesTest.moc"

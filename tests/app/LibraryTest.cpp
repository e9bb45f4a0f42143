// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Library.h"

#include "app/files/NewTree.h"
#include "commands/GrowGesture.h"
#include "commands/SetParameters.h"
#include "tests/support/LibraryProjects.h"
#include "tests/support/TestClasses.h"

#include <QChar>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QIODevice>
#include <QImage>
#include <QLatin1Char>
#include <QSize>
#include <QTemporaryDir>
#include <QTest>

using namespace espalier;
using test::namesOf;
using test::project;

/// The library's folder, without a window.
class LibraryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void species_areTheProgramsRecipes();
    void newFile_findsAFreeName();
    void rename_movesTheFile();
    void rename_refusesWhatCannotBeAName_data();
    void rename_refusesWhatCannotBeAName();
    void rename_refusesATakenName();
    void duplicate_countsOn();
    void trash_isTheSystemsOrElseTheLibrarys();
    void trash_saysWhenTheFileIsGone();
    void parameters_areThoseOfTheTree();
    void picture_ofABrokenFileIsAnError();

private:
    QString file(const QString& name) { return m_folder->filePath(name + QStringLiteral(".espalier")); }
    void put(const QString& name);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Library> m_library;
    QStringList m_trash;
    bool m_hasTrash = true;
};

void LibraryTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_trash.clear();
    m_hasTrash = true;
    m_library = std::make_unique<Library>(m_folder->path(), [this](const QString& fileName) {
        if (m_hasTrash) {
            m_trash.append(fileName);
            QFile::remove(fileName);
        }
        return m_hasTrash ? std::optional(QString()) : std::nullopt;
    });
}

void LibraryTest::put(const QString& name)
{
    QVERIFY(saveProject(project(1.0), file(name)));
}

void LibraryTest::species_areTheProgramsRecipes()
{
    const std::vector<LibraryEntry> species = Library::species();
    QCOMPARE(
        static_cast<int>(species.size()),
        static_cast<int>(QDir(QStringLiteral(":/recipes")).entryList({QStringLiteral("*.json")}).size()));
    QVERIFY(species.size() >= 16);
    for (const LibraryEntry& entry : species) {
        QVERIFY2(!entry.line.isEmpty(), qPrintable(entry.name));
        const Result<QImage> picture = libraryPicture(entry.fileName);
        QVERIFY2(picture && picture->size() == QSize(256, 224), qPrintable(entry.fileName));
    }
}

void LibraryTest::newFile_findsAFreeName()
{
    Library library(m_folder->filePath(QStringLiteral("not/there/yet")));
    const Result<QString> first = library.newFile(QStringLiteral("Oak"));
    QVERIFY(first);
    QCOMPARE(*first, m_folder->filePath(QStringLiteral("not/there/yet/Oak.espalier")));
    QVERIFY(library.holds(*first));
    QVERIFY(saveProject(project(1.0), *first));
    QVERIFY(library.newFile(QStringLiteral("Oak"))->endsWith(QStringLiteral("/Oak 2.espalier")));
    QVERIFY(library.newFile(QStringLiteral("Oak 7"))->endsWith(QStringLiteral("/Oak 7.espalier")));
    QVERIFY(library.newFile(QStringLiteral("a/b"))->endsWith(QStringLiteral("/Tree.espalier")));
}

void LibraryTest::rename_movesTheFile()
{
    put(QStringLiteral("Oak"));
    const Result<QString> moved =
        m_library->rename(file(QStringLiteral("Oak")), QStringLiteral(" Old “Oak” "));
    QVERIFY(moved);
    QCOMPARE(*moved, file(QStringLiteral("Old “Oak”")));
    QCOMPARE(namesOf(m_library->trees()), QStringList{QStringLiteral("Old “Oak”")});
    QCOMPARE(*m_library->rename(*moved, QStringLiteral("Old “Oak”")), *moved);
}

void LibraryTest::rename_refusesWhatCannotBeAName_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("nothing") << QStringLiteral("  ");
    QTest::newRow("folder") << QStringLiteral("../Oak");
    QTest::newRow("backslash") << QStringLiteral("a\\b");
    QTest::newRow("hidden") << QStringLiteral(".Oak");
    QTest::newRow("line break") << QStringLiteral("a\nb");
    QTest::newRow("too long") << QString(201, QLatin1Char('o'));
    QTest::newRow("too long in bytes") << QString(120, QChar(0x00e9));
}

void LibraryTest::rename_refusesWhatCannotBeAName()
{
    QFETCH(QString, name);
    put(QStringLiteral("Oak"));
    const Result<QString> moved = m_library->rename(file(QStringLiteral("Oak")), name);
    QVERIFY(!moved);
    QVERIFY(moved.error().message.endsWith(QLatin1Char('.')));
    QVERIFY(QFileInfo::exists(file(QStringLiteral("Oak"))));
}

void LibraryTest::rename_refusesATakenName()
{
    put(QStringLiteral("Oak"));
    put(QStringLiteral("Elm"));
    const Result<QString> moved = m_library->rename(file(QStringLiteral("Oak")), QStringLiteral("Elm"));
    QVERIFY(!moved);
    QVERIFY(moved.error().message.contains(QStringLiteral("Elm")));
    QCOMPARE(m_library->trees().size(), std::size_t{2});
}

void LibraryTest::duplicate_countsOn()
{
    put(QStringLiteral("Oak"));
    const Result<QString> copy = m_library->duplicate(file(QStringLiteral("Oak")));
    QVERIFY(copy);
    QCOMPARE(*copy, file(QStringLiteral("Oak 2")));
    QCOMPARE(*m_library->duplicate(*copy), file(QStringLiteral("Oak 3")));
    QVERIFY(loadProject(*copy));
    QVERIFY(!m_library->duplicate(file(QStringLiteral("Elm"))));
}

void LibraryTest::trash_isTheSystemsOrElseTheLibrarys()
{
    put(QStringLiteral("Oak"));
    QVERIFY(m_library->moveToTrash(file(QStringLiteral("Oak")))->isSystems);
    QCOMPARE(m_trash, QStringList{file(QStringLiteral("Oak"))});

    m_hasTrash = false;
    for (const char* expected : {"Trash/Oak.espalier", "Trash/Oak 2.espalier"}) {
        put(QStringLiteral("Oak"));
        const Result<Library::Trashed> moved = m_library->moveToTrash(file(QStringLiteral("Oak")));
        QVERIFY(moved && !moved->isSystems);
        QCOMPARE(moved->path, m_folder->filePath(QString::fromLatin1(expected)));
        QVERIFY(loadProject(moved->path));
    }
    QVERIFY(m_library->trees().empty());
}

void LibraryTest::trash_saysWhenTheFileIsGone()
{
    const Result<Library::Trashed> moved = m_library->moveToTrash(file(QStringLiteral("Oak")));
    QVERIFY(!moved);
    QVERIFY(moved.error().message.contains(QStringLiteral("Oak")));
    QVERIFY(m_trash.isEmpty());
}

void LibraryTest::parameters_areThoseOfTheTree()
{
    QVERIFY(saveProject(project(1.25), file(QStringLiteral("Oak"))));
    const Result<NewTree> kept = NewTree::like(file(QStringLiteral("Oak")));
    QVERIFY(kept);
    QCOMPARE(kept->parameters.growth.branchingAngle, 1.25);
    QCOMPARE(kept->name, QStringLiteral("Oak"));
    const QString willow = QStringLiteral(":/recipes/willow.json");
    QVERIFY(NewTree::like(willow)->parameters == readRecipe(willow)->parameters);
}

void LibraryTest::picture_ofABrokenFileIsAnError()
{
    QFile broken(file(QStringLiteral("Broken")));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("PK no archive");
    broken.close();
    const Result<QImage> picture = libraryPicture(broken.fileName());
    QVERIFY(!picture);
    QVERIFY(picture.error().message.contains(QStringLiteral("Broken")));
    QVERIFY(!NewTree::like(broken.fileName()));
}

static const test::TestClass<LibraryTest> libraryTest;

#include "LibraryTest.moc"

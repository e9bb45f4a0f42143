// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Library.h"

#include "app/LibraryPanel.h"
#include "app/LibraryView.h"
#include "app/MainWindow.h"
#include "commands/GrowGesture.h"
#include "commands/SetParameters.h"
#include "panels/Notice.h"
#include "tests/support/TestClasses.h"
#include "views/Viewport.h"

#include <QtTest>
#include <QtWidgets>

using namespace espalier;

namespace {

QStringList namesOf(const std::vector<LibraryEntry>& entries)
{
    QStringList names;
    for (const LibraryEntry& entry : entries)
        names.append(entry.name);
    return names;
}

/// A project whose tree grows as no other does.
Project project(double branchingAngle)
{
    TreeParameters parameters;
    parameters.growth.branchingAngle = branchingAngle;
    TreeDocument document;
    document.reset(3, parameters);
    GrowGesture growth(document);
    for (int i = 0; i < 3; ++i)
        growth.step();
    growth.finish();
    Project project{document.tree(), document.journal(), QStringLiteral("any"), {}, 0};
    project.thumbnail = QImage(64, 64, QImage::Format_RGB32);
    project.thumbnail.fill(Qt::red);
    return project;
}

} // namespace

/// The folder that a library is, without a window.
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
        return m_hasTrash;
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
    QCOMPARE(*m_library->moveToTrash(file(QStringLiteral("Oak"))), QString());
    QCOMPARE(m_trash, QStringList{file(QStringLiteral("Oak"))});

    m_hasTrash = false;
    for (const char* expected : {"Trash/Oak.espalier", "Trash/Oak 2.espalier"}) {
        put(QStringLiteral("Oak"));
        const Result<QString> moved = m_library->moveToTrash(file(QStringLiteral("Oak")));
        QVERIFY(moved);
        QCOMPARE(*moved, m_folder->filePath(QString::fromLatin1(expected)));
        QVERIFY(loadProject(*moved));
    }
    QVERIFY(m_library->trees().empty());
}

void LibraryTest::trash_saysWhenTheFileIsGone()
{
    const Result<QString> moved = m_library->moveToTrash(file(QStringLiteral("Oak")));
    QVERIFY(!moved);
    QVERIFY(moved.error().message.contains(QStringLiteral("Oak")));
    QVERIFY(m_trash.isEmpty());
}

void LibraryTest::parameters_areThoseOfTheTree()
{
    QVERIFY(saveProject(project(1.25), file(QStringLiteral("Oak"))));
    const Result<TreeParameters> kept = libraryParameters(file(QStringLiteral("Oak")));
    QVERIFY(kept);
    QCOMPARE(kept->growth.branchingAngle, 1.25);
    const QString willow = QStringLiteral(":/recipes/willow.json");
    QVERIFY(*libraryParameters(willow) == readRecipe(willow)->parameters);
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
    QVERIFY(!libraryParameters(broken.fileName()));
}

/// A person in the library, at the real window.
class LibraryPanelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void cleanupTestCase() { m_window.reset(); }

    void search_filtersBothSections();
    void keys_areTheLibrarysWhileItIsOpen();
    void startFromASpecies_isASeedlingWithItsParameters();
    void startFromATree_asksAboutUnsavedWork();
    void doubleClick_growsASpecies();
    void enter_opensATree();
    void keep_savesTheTreeAndAsksForItsName();
    void menu_duplicatesRenamesAndTrashes();
    void finger_opensTheMenuByTheDotsAndByALongPress();
    void openTree_followsItsFile();
    void brokenFile_hasACardThatSaysSo();
    void library_looksLikeThis();

private:
    QWindow* handle() { return m_window->windowHandle(); }
    LibraryPanel& panel() { return m_window->workspace().library(); }
    CardView& view() { return *panel().findChild<CardView*>(); }
    QString file(const QString& name) { return m_folder.filePath(name + QStringLiteral(".espalier")); }
    QString notice() { return m_window->workspace().notice().text(); }
    void open(LibraryPanel::Section section);
    /// A point of the window: the middle of a card's picture, or its dots.
    QPoint cardAt(int row, bool dots = false);
    QPoint middleOf(const QWidget& widget) { return widget.mapTo(m_window.get(), widget.rect().center()); }
    QPushButton* button(const char* name)
    {
        return panel().findChild<QPushButton*>(QString::fromLatin1(name));
    }
    void answer(QMessageBox::StandardButton button);
    void trigger(const QString& text);
    /// Plain letters, to whatever has the keys.
    void type(const QString& text)
    {
        for (const QChar letter : text)
            QTest::keyClick(handle(), letter.toLatin1());
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    QPointingDevice* m_screen = QTest::createTouchDevice();
};

void LibraryPanelTest::init()
{
    QSettings().clear();
    Preferences preferences;
    preferences.libraryFolder = m_folder.path();
    Settings().setPreferences(preferences);
    // A window takes its time to come up where the processor draws it, so that the tests share one.
    if (!m_window)
        m_window = std::make_unique<MainWindow>();
    m_window->resize(1024, 700);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewSettings().setValues({.shadowsShown = false});
}

void LibraryPanelTest::cleanup()
{
    // Nobody is there to answer a question.
    m_window->document().undoStack().setClean();
    m_window->workspace().notice().finish();
    m_window->actions()[ActionId::New]->trigger();
    m_window->actions()[ActionId::Library]->setChecked(false);
    panel().showSection(LibraryPanel::Section::Species);
    QDir folder(m_folder.path());
    folder.removeRecursively();
    folder.mkpath(m_folder.path());
}

void LibraryPanelTest::open(LibraryPanel::Section section)
{
    QTest::keyClick(handle(), Qt::Key_L, Qt::ControlModifier);
    QTRY_VERIFY(panel().isVisible());
    if (section == LibraryPanel::Section::Trees)
        panel().findChild<QAction*>(QStringLiteral("trees"))->trigger();
    else
        QTRY_VERIFY(view().model()->rowCount() >= 16);
    view().setFocus();
    QCoreApplication::processEvents();
}

QPoint LibraryPanelTest::cardAt(int row, bool dots)
{
    const QRect card = view().visualRect(view().model()->index(row, 0));
    return view().viewport()->mapTo(m_window.get(), dots ? CardPainter::menuPlace(card).center()
                                                         : card.center() - QPoint(0, 40));
}

void LibraryPanelTest::answer(QMessageBox::StandardButton button)
{
    QTimer::singleShot(100, this, [this, button] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return answer(button);
        box->button(button)->click();
    });
}

void LibraryPanelTest::trigger(const QString& text)
{
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu);
    for (QAction* action : menu->actions()) {
        if (action->text() == text) {
            action->trigger();
            menu->close();
            return;
        }
    }
    QFAIL(qPrintable(text));
}

void LibraryPanelTest::search_filtersBothSections()
{
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("My willow"))));
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Elm"))));
    open(LibraryPanel::Section::Species);
    const int all = view().model()->rowCount();
    // Letters go to the search, wherever the keys are, and not to the tools.
    type(QStringLiteral("w"));
    QTRY_VERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
    type(QStringLiteral("illow WEEP"));
    QTRY_COMPARE(view().model()->rowCount(), 1);
    QCOMPARE(panel().chosen(), QStringLiteral(":/recipes/willow.json"));
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(handle(), Qt::Key_Backspace);
    panel().findChild<QAction*>(QStringLiteral("trees"))->trigger();
    QCOMPARE(view().model()->rowCount(), 1);
    QCOMPARE(panel().chosen(), file(QStringLiteral("My willow")));
    QTest::keyClick(handle(), Qt::Key_Escape);
    QCOMPARE(view().model()->rowCount(), 2);
    panel().findChild<QAction*>(QStringLiteral("species"))->trigger();
    QCOMPARE(view().model()->rowCount(), all);
    QTest::keyClick(handle(), Qt::Key_F, Qt::ControlModifier);
    QTRY_VERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!panel().isVisible());
    QCOMPARE(QApplication::focusWidget(), &m_window->workspace().viewport());
}

void LibraryPanelTest::keys_areTheLibrarysWhileItIsOpen()
{
    open(LibraryPanel::Section::Species);
    const QString first = panel().chosen();
    QTest::keyClick(handle(), Qt::Key_Right);
    QVERIFY(panel().chosen() != first);
    QTest::keyClick(handle(), Qt::Key_Left);
    QCOMPARE(panel().chosen(), first);
    QTest::keyClick(handle(), Qt::Key_Down);
    QVERIFY(panel().chosen() != first);
    QTest::keyClick(handle(), Qt::Key_Delete);
    QTest::keyClick(handle(), Qt::Key_F2);
    QVERIFY(!view().findChild<QLineEdit*>());
    QTest::keyClick(handle(), Qt::Key_G);
    QCOMPARE(m_window->document().tree().step(), Step{0});
    QTest::keyClick(handle(), Qt::Key_L, Qt::ControlModifier);
    QTRY_VERIFY(!panel().isVisible());
}

void LibraryPanelTest::startFromASpecies_isASeedlingWithItsParameters()
{
    open(LibraryPanel::Section::Species);
    panel().choose(QStringLiteral(":/recipes/willow.json"));
    QTest::mouseClick(handle(), Qt::LeftButton, {}, middleOf(*button("start")));
    QTRY_VERIFY(!panel().isVisible());
    const TreeDocument& document = m_window->document();
    QCOMPARE(document.index().livingCount(), 1U);
    QCOMPARE(document.tree().step(), Step{0});
    QVERIFY(document.parameters() == readRecipe(QStringLiteral(":/recipes/willow.json"))->parameters);
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(m_window->files().file().fileName().isEmpty());
}

void LibraryPanelTest::startFromATree_asksAboutUnsavedWork()
{
    QVERIFY(saveProject(project(1.25), file(QStringLiteral("Elm"))));
    QTest::keyClick(handle(), Qt::Key_G);
    TreeDocument& document = m_window->document();
    QTRY_COMPARE(document.tree().step(), Step{1});
    QTRY_VERIFY(!m_window->growRunner().isRunning());
    open(LibraryPanel::Section::Trees);
    answer(QMessageBox::Cancel);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, middleOf(*button("start")));
    QTest::qWait(400);
    QCOMPARE(document.tree().step(), Step{1});
    QVERIFY(panel().isVisible());

    answer(QMessageBox::Discard);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, middleOf(*button("start")));
    QTRY_VERIFY(!panel().isVisible());
    QCOMPARE(document.index().livingCount(), 1U);
    QCOMPARE(document.parameters().growth.branchingAngle, 1.25);
}

void LibraryPanelTest::doubleClick_growsASpecies()
{
    open(LibraryPanel::Section::Species);
    panel().choose(QStringLiteral(":/recipes/candelabra.json"));
    const QPoint place = cardAt(view().currentIndex().row());
    QTest::mouseDClick(handle(), Qt::LeftButton, {}, place);
    QTRY_VERIFY(!panel().isVisible());
    QVERIFY(m_window->recipeRunner().isRunning());
    QTRY_VERIFY2_WITH_TIMEOUT(!m_window->recipeRunner().isRunning(), "it goes on", 60000);
    QVERIFY(m_window->document().index().livingCount() > 100);
    QVERIFY(m_window->isWindowModified());
    QVERIFY(!m_window->workspace().notice().isVisible());
    // The folder that files are looked for in stays the person's.
    QVERIFY(!Settings().folder().startsWith(QLatin1Char(':')));
}

void LibraryPanelTest::enter_opensATree()
{
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Elm"))));
    open(LibraryPanel::Section::Trees);
    QTest::keyClick(handle(), Qt::Key_Return);
    QTRY_VERIFY(!panel().isVisible());
    QCOMPARE(m_window->files().file().fileName(), file(QStringLiteral("Elm")));
    QVERIFY(m_window->document().tree() == project(1.0).tree);
}

void LibraryPanelTest::keep_savesTheTreeAndAsksForItsName()
{
    QTest::keyClick(handle(), Qt::Key_G);
    QTRY_COMPARE(m_window->document().tree().step(), Step{1});
    QTRY_VERIFY(!m_window->growRunner().isRunning());
    open(LibraryPanel::Section::Trees);
    QVERIFY(panel().chosen().isEmpty());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, middleOf(*button("keep")));
    QTRY_VERIFY(view().findChild<QLineEdit*>());
    QTest::keyClick(handle(), Qt::Key_A, Qt::ControlModifier);
    type(QStringLiteral("Rowan"));
    QTest::keyClick(handle(), Qt::Key_Return);
    QTRY_COMPARE(panel().chosen(), file(QStringLiteral("Rowan")));
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(m_window->files().file().fileName(), file(QStringLiteral("Rowan")));
    QVERIFY(!loadProject(file(QStringLiteral("Rowan")))->thumbnail.isNull());
    QTRY_VERIFY(!view().currentIndex().data(Qt::DecorationRole).value<QImage>().isNull());

    // A tree that has its file elsewhere leaves a copy here.
    QTemporaryDir elsewhere;
    DocumentFile& own = m_window->files().file();
    QSignalSpy saved(&own, &DocumentFile::saved);
    own.save(elsewhere.filePath(QStringLiteral("Rowan.espalier")), {});
    QVERIFY(saved.wait());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, middleOf(*button("keep")));
    QTRY_VERIFY(QFileInfo::exists(file(QStringLiteral("Rowan 2"))));
    QCOMPARE(own.fileName(), elsewhere.filePath(QStringLiteral("Rowan.espalier")));
}

void LibraryPanelTest::menu_duplicatesRenamesAndTrashes()
{
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Elm"))));
    open(LibraryPanel::Section::Trees);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, cardAt(0, true));
    QTRY_VERIFY(QApplication::activePopupWidget());
    trigger(QStringLiteral("Duplicate"));
    QTRY_COMPARE(panel().chosen(), file(QStringLiteral("Elm 2")));
    QTest::keyClick(handle(), Qt::Key_F2);
    QTRY_VERIFY(view().findChild<QLineEdit*>());
    // No two trees have one name; it is said, and the file stays.
    QTest::keyClick(handle(), Qt::Key_A, Qt::ControlModifier);
    type(QStringLiteral("Elm"));
    QTest::keyClick(handle(), Qt::Key_Return);
    QTRY_VERIFY2(notice().contains(QStringLiteral("already")), qPrintable(notice()));
    QVERIFY(QFileInfo::exists(file(QStringLiteral("Elm 2"))));
    QTest::keyClick(handle(), Qt::Key_F2);
    QTRY_VERIFY(view().findChild<QLineEdit*>());
    QTest::keyClick(handle(), Qt::Key_A, Qt::ControlModifier);
    type(QStringLiteral("Ash"));
    QTest::keyClick(handle(), Qt::Key_Return);
    QTRY_VERIFY(QFileInfo::exists(file(QStringLiteral("Ash"))));
    QTRY_COMPARE(panel().chosen(), file(QStringLiteral("Ash")));
    QTest::keyClick(handle(), Qt::Key_Delete);
    QTRY_VERIFY(!QFileInfo::exists(file(QStringLiteral("Ash"))));
    QVERIFY2(notice().contains(QStringLiteral("Ash")), qPrintable(notice()));
    QCOMPARE(view().model()->rowCount(), 1);
}

void LibraryPanelTest::finger_opensTheMenuByTheDotsAndByALongPress()
{
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Ash"))));
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Elm"))));
    open(LibraryPanel::Section::Trees);
    const auto press = [this](const QPoint& place, int wait) {
        QTest::touchEvent(handle(), m_screen).press(1, place, handle());
        QTest::qWait(wait);
        QTest::touchEvent(handle(), m_screen).release(1, place, handle());
    };
    QVERIFY(CardPainter::menuPlace(view().visualRect(view().model()->index(1, 0))).width() >= 44);
    press(cardAt(1), 30);
    QTRY_COMPARE(view().currentIndex().row(), 1);
    press(cardAt(0, true), 30);
    QTRY_VERIFY(QApplication::activePopupWidget());
    QCOMPARE(view().currentIndex().row(), 0);
    QApplication::activePopupWidget()->close();
    QTRY_VERIFY(!QApplication::activePopupWidget());
    press(cardAt(1), 900);
    QTRY_VERIFY(QApplication::activePopupWidget());
    trigger(QStringLiteral("Open"));
    QTRY_VERIFY(!panel().isVisible());
    QVERIFY(!m_window->files().file().fileName().isEmpty());
}

void LibraryPanelTest::openTree_followsItsFile()
{
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Elm"))));
    m_window->files().openFile(file(QStringLiteral("Elm")));
    const DocumentFile& own = m_window->files().file();
    open(LibraryPanel::Section::Trees);
    Q_EMIT panel().renameAsked(panel().chosen(), QStringLiteral("Ash"));
    QTRY_COMPARE(own.fileName(), file(QStringLiteral("Ash")));
    QVERIFY(!m_window->isWindowModified());
    // Without its file all of the tree is unsaved, and nobody loses it unasked.
    QTest::keyClick(handle(), Qt::Key_Delete);
    QTRY_VERIFY(own.fileName().isEmpty());
    QCOMPARE(own.displayName(), QStringLiteral("Ash"));
    QVERIFY(m_window->isWindowModified());
    m_window->files().startFrom(QStringLiteral(":/recipes/oak.json"));
    answer(QMessageBox::Discard);
    QTRY_VERIFY(!panel().isVisible());
    QVERIFY(!m_window->isWindowModified());
}

void LibraryPanelTest::brokenFile_hasACardThatSaysSo()
{
    QFile broken(file(QStringLiteral("Broken")));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("PK no archive");
    broken.close();
    open(LibraryPanel::Section::Trees);
    QCOMPARE(view().model()->rowCount(), 1);
    const QModelIndex card = view().model()->index(0, 0);
    QTRY_VERIFY2(card.data(Qt::ToolTipRole).toString().contains(QStringLiteral("Broken")),
                 qPrintable(card.data(Qt::ToolTipRole).toString()));
    QVERIFY(card.data(Qt::DecorationRole).value<QImage>().isNull());
    QTest::keyClick(handle(), Qt::Key_Return);
    QTRY_VERIFY(m_window->workspace().notice().isWarning());
    QVERIFY2(notice().contains(QStringLiteral("Broken")), qPrintable(notice()));
    m_window->files().startFrom(file(QStringLiteral("Broken")));
    QTest::qWait(100);
    QCOMPARE(m_window->document().index().livingCount(), 1U);
}

void LibraryPanelTest::library_looksLikeThis()
{
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Old oak by the river"))));
    open(LibraryPanel::Section::Species);
    const auto shoot = [this](const char* name) {
        QTest::qWait(300);
        const QPixmap picture = m_window->screen()->grabWindow(m_window->winId());
        QVERIFY(picture.save(QString::fromLatin1(name)));
        QVERIFY(picture.size() == m_window->size());
    };
    for (int row = 0; row < view().model()->rowCount(); ++row)
        QTRY_VERIFY(!view().model()->index(row, 0).data(Qt::DecorationRole).value<QImage>().isNull());
    shoot("library-small.png");
    m_window->resize(1590, 990);
    shoot("library.png");
    panel().showSection(LibraryPanel::Section::Trees);
    panel().editName();
    shoot("library-trees.png");
    m_window->resize(1024, 700);
}

namespace {

const test::TestClass<LibraryTest> kLibraryEntered;
const test::TestClass<LibraryPanelTest> kLibraryPanelEntered;

} // namespace

#include "LibraryTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/library/LibraryPanel.h"

#include "app/MainWindow.h"
#include "commands/GrowGesture.h"
#include "commands/SetParameters.h"
#include "panels/Notice.h"
#include "panels/library/LibraryView.h"
#include "tests/support/LibraryProjects.h"
#include "tests/support/TestClasses.h"
#include "views/Viewport.h"

#include <QAction>
#include <QApplication>
#include <QChar>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QIODevice>
#include <QImage>
#include <QLatin1Char>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QModelIndex>
#include <QPixmap>
#include <QPoint>
#include <QPointingDevice>
#include <QPushButton>
#include <QRect>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWidget>
#include <QWindow>

using namespace espalier;
using test::project;

/// The user in the library, at the real window.
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
    /// Types plain letters; the widget with the keyboard focus gets them.
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
    // The tests share one window, because it takes long to appear where the processor draws it.
    if (!m_window)
        m_window = std::make_unique<MainWindow>();
    m_window->resize(1024, 700);
    m_window->workspace().viewport().setBestSamples(1);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewSettings().setValues({});
    SceneLook look;
    look.shadowsShown = false;
    m_window->files().file().setLookOfNewTrees(look);
    m_window->document().setLook(look);
    m_window->files().file().setUnmodified();
}

void LibraryPanelTest::cleanup()
{
    // A question about unsaved changes would wait for an answer for ever.
    m_window->files().file().setUnmodified();
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
    // Letters go to the search, not to the tools, wherever the focus is.
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
    // Also if something else has the focus.
    open(LibraryPanel::Section::Species);
    m_window->workspace().viewport().setFocus();
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!panel().isVisible());
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
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(!m_window->workspace().notice().isVisible());
    // The folder of the file dialogs does not become one of the program's resources.
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

    // A tree whose file is elsewhere is copied into the library.
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
    // Two trees cannot have the same name: a notice says so, and the file stays.
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
    // The notice offers to take it back, with all that the trash knows of it.
    QPushButton* undo = nullptr;
    for (auto* button : m_window->workspace().notice().findChildren<QPushButton*>()) {
        if (button->isVisible() && button->text() == QStringLiteral("Undo"))
            undo = button;
    }
    QVERIFY(undo);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, undo->mapTo(m_window.get(), undo->rect().center()));
    QTRY_VERIFY(QFileInfo::exists(file(QStringLiteral("Ash"))));
    QTRY_COMPARE(view().model()->rowCount(), 2);
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
    QTRY_VERIFY(!m_window->files().file().fileName().isEmpty());
}

void LibraryPanelTest::openTree_followsItsFile()
{
    QVERIFY(saveProject(project(1.0), file(QStringLiteral("Elm"))));
    QSignalSpy opened(&m_window->files(), &FileController::opened);
    m_window->files().openFile(file(QStringLiteral("Elm")));
    QVERIFY(opened.wait(30'000));
    const DocumentFile& own = m_window->files().file();
    open(LibraryPanel::Section::Trees);
    Q_EMIT panel().renameAsked(panel().chosen(), QStringLiteral("Ash"));
    QTRY_COMPARE(own.fileName(), file(QStringLiteral("Ash")));
    QVERIFY(!m_window->isWindowModified());
    // Without its file the whole tree is unsaved, so the program asks before it closes the tree.
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

static const test::TestClass<LibraryPanelTest> libraryPanelTest;

#include "LibraryPanelTest.moc"

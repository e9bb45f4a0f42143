// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HelpController.h"
#include "app/MainWindow.h"
#include "app/Tour.h"
#include "commands/RecipePlayer.h"
#include "panels/BrushPopOut.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPage.h"
#include "panels/HelpPanel.h"
#include "panels/ParameterPanel.h"
#include "panels/ParameterTexts.h"
#include "panels/RadiusSlider.h"
#include "panels/Theme.h"
#include "views/Viewport.h"
#include "views/render/GlResources.h"

#include <QtTest>
#include <QtWidgets>

using namespace espalier;

/// The pages of the help, and a person who reads them at the real window.
class HelpTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { theme::apply(*qApp); }
    void init();
    void cleanup();
    void cleanupTestCase() { m_window.reset(); }

    void contents_haveEveryPageAndNoOther();
    void pages_havePicturesAndNoDeadLinks_data();
    void pages_havePicturesAndNoDeadLinks();
    void subjects_haveAPageWithAPictureAndARecipe();
    void recipes_doSomethingInEachOperation_data();
    void recipes_doSomethingInEachOperation();
    void keysPage_hasEveryShortcut();
    void sheetPages_haveEveryParameter();
    void language_fallsBackToEnglish();
    void search_findsTitlesFirst();

    void f1_opensThePageOfTheToolInHand_data();
    void f1_opensThePageOfTheToolInHand();
    void f1InASheet_opensItsPage();
    void button_opensAndEscapeCloses();
    void links_leadToPagesAndBack();
    void searchField_opensWhatItFinds();
    void keys_readAndFollowLinks();
    void narrowWindow_hasTheContentsInPlaceOfThePage();
    void playing_asksAboutUnsavedWorkAndLeavesNone();
    void tour_goesOnByDoing();
    void tour_isSkippedAndNeverComesBack();
    void help_looksLikeThis();

private:
    Workspace& workspace() { return m_window->workspace(); }
    HelpPanel& help() { return workspace().help(); }
    QWindow* handle() { return m_window->windowHandle(); }
    QAction* action(ActionId id) { return m_window->actions()[id]; }
    template <class Widget>
    Widget* part(const char* name)
    {
        return help().findChild<Widget*>(QString::fromLatin1(name));
    }
    QPushButton* tourButton(const char* name)
    {
        return workspace().findChild<QPushButton*>(QString::fromLatin1(name));
    }
    void click(QWidget* widget);
    void drag(const QPoint& from, const QPoint& to);
    void answer(QMessageBox::StandardButton button);

    std::unique_ptr<MainWindow> m_window;
};

namespace {

constexpr const char* kRoot = ":/docs/help/en";

QStringList pageNames()
{
    QStringList names;
    for (const QString& file : QDir(QString::fromLatin1(kRoot)).entryList({QStringLiteral("*.md")}))
        names.append(file.chopped(3));
    return names;
}

QString read(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

void HelpTest::init()
{
    QSettings().clear();
    // A window takes its time to come up where the processor draws it, so that the tests share one.
    if (!m_window)
        m_window = std::make_unique<MainWindow>();
    m_window->resize(1200, 700);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewSettings().setValues({.shadowsShown = false});
    action(ActionId::Brush)->trigger();
    workspace().viewport().setFocus();
}

void HelpTest::cleanup()
{
    m_window->help().tour().stop();
    workspace().showHelp(false);
    m_window->recipeRunner().stop();
    m_window->document().undoStack().setClean();
    action(ActionId::New)->trigger();
}

void HelpTest::click(QWidget* widget)
{
    QVERIFY(widget && widget->isVisible());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, widget->mapTo(m_window.get(), widget->rect().center()));
    QCoreApplication::processEvents();
}

void HelpTest::drag(const QPoint& from, const QPoint& to)
{
    constexpr int kMoves = 15;
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= kMoves; ++i) {
        QTest::mouseMove(handle(), from + (to - from) * i / kMoves);
        QTest::qWait(20);
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, to);
    QCoreApplication::processEvents();
}

void HelpTest::answer(QMessageBox::StandardButton button)
{
    QTimer::singleShot(100, this, [this, button] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return answer(button);
        box->button(button)->click();
    });
}

void HelpTest::contents_haveEveryPageAndNoOther()
{
    QStringList listed;
    for (const HelpBook::Section& section : help().book().contents()) {
        for (const HelpBook::Entry& entry : section.entries)
            listed.append(entry.page);
    }
    QCOMPARE(listed.value(0), HelpBook::kIndex);
    listed.sort();
    QCOMPARE(listed, pageNames());
}

void HelpTest::pages_havePicturesAndNoDeadLinks_data()
{
    QTest::addColumn<QString>("page");
    for (const QString& name : pageNames())
        QTest::newRow(qPrintable(name)) << name;
}

void HelpTest::pages_havePicturesAndNoDeadLinks()
{
    QFETCH(QString, page);
    help().showPage(page);
    QCOMPARE(help().page(), page);
    auto* shown = part<HelpPage>("helpPage");
    QVERIFY(shown->document()->begin().blockFormat().headingLevel() == 1);
    for (const QString& name : shown->pictures()) {
        const QString file = QLatin1Char(':') + shown->url().resolved(QUrl(name)).path();
        const QImage picture(file);
        QVERIFY2(!picture.isNull(), qPrintable(name));
        QVERIFY2(picture.width() <= 640 && QFileInfo(file).size() < 100'000, qPrintable(name));
    }
    for (const QString& link : shown->links()) {
        QString file = shown->url().resolved(QUrl(link)).path();
        QVERIFY2(QFile::exists(QStringLiteral(SOURCE_DIR) + file), qPrintable(link)); // As on the web
        file.replace(QStringLiteral("/resources/"), QStringLiteral("/"));
        QVERIFY2(QFile::exists(QLatin1Char(':') + file), qPrintable(link));
    }
}

void HelpTest::subjects_haveAPageWithAPictureAndARecipe()
{
    std::vector<ActionId> subjects(Actions::tools().begin(), Actions::tools().end());
    for (const ActionId id :
         {ActionId::Architecture, ActionId::LeafSheet, ActionId::BranchSheet, ActionId::History})
        subjects.push_back(id);
    for (const ActionId id : subjects) {
        const QString page = action(id)->objectName();
        help().showPage(page);
        QVERIFY2(help().page() == page, qPrintable(page));
        QVERIFY2(!part<HelpPage>("helpPage")->pictures().isEmpty(), qPrintable(page));
        QVERIFY2(help().recipe().endsWith(QStringLiteral("/%1.json").arg(page)), qPrintable(help().recipe()));
        QVERIFY(part<QPushButton>("helpPlay")->isVisibleTo(&help()));
    }
}

void HelpTest::recipes_doSomethingInEachOperation_data()
{
    QTest::addColumn<QString>("file");
    const QDir folder(QStringLiteral(":/docs/help/recipes"));
    QVERIFY(folder.entryList().size() > 10);
    for (const QString& name : folder.entryList())
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

void HelpTest::recipes_doSomethingInEachOperation()
{
    QFETCH(QString, file);
    const Result<Recipe> recipe = readRecipe(file);
    QVERIFY2(recipe, recipe ? "" : qPrintable(recipe.error().message));
    QVERIFY(!recipe->name.isEmpty() && !recipe->description.isEmpty());
    TreeDocument document;
    RecipePlayer player(document, *recipe);
    for (std::size_t i = 0; i < recipe->operations.size(); ++i) {
        const Tree before = document.tree();
        player.playOperation();
        QVERIFY2(!(document.tree() == before), qPrintable(QStringLiteral("operations[%1]").arg(i)));
    }
    QVERIFY(player.isDone());
    QVERIFY(document.index().livingCount() > 100);
}

void HelpTest::keysPage_hasEveryShortcut()
{
    const QStringList lines =
        read(QStringLiteral("%1/keys.md").arg(QString::fromLatin1(kRoot))).split(QLatin1Char('\n'));
    for (const ActionEntry& entry : Actions::table()) {
        QString text = QString::fromUtf8(entry.text).remove(QChar(0x2026));
        for (const QString& key : QString::fromLatin1(entry.shortcuts).split(QStringLiteral("; "))) {
            const bool isThere =
                key.isEmpty() || std::ranges::any_of(lines, [&](const QString& line) {
                    return line.contains(text) && line.contains(QLatin1Char('`') + key + QLatin1Char('`'));
                });
            QVERIFY2(
                isThere,
                qPrintable(
                    QStringLiteral("docs/help/en/keys.md lacks a line with \"%1\" and `%2`").arg(text, key)));
        }
    }
}

void HelpTest::sheetPages_haveEveryParameter()
{
    for (const ParameterSection& section : parameterSections()) {
        const char* name = section.sheet == ParameterSheet::Architecture ? "architecture"
                           : section.sheet == ParameterSheet::Brush      ? "brush"
                           : section.sheet == ParameterSheet::Leaves     ? "leafSheet"
                                                                         : "branchSheet";
        const QString page =
            read(QStringLiteral("%1/%2.md").arg(QString::fromLatin1(kRoot), QString::fromLatin1(name)));
        for (const ParameterText& text : section.parameters) {
            QVERIFY2(page.contains(QString::fromUtf8(text.label)),
                     qPrintable(QStringLiteral("docs/help/en/%1.md says nothing of \"%2\"")
                                    .arg(QString::fromLatin1(name), QString::fromUtf8(text.label))));
        }
    }
}

void HelpTest::language_fallsBackToEnglish()
{
    QTemporaryDir folder;
    QDir root(folder.path());
    const auto write = [&](const char* name, const QByteArray& text) {
        root.mkpath(QFileInfo(QString::fromLatin1(name)).path());
        QFile file(root.filePath(QString::fromLatin1(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    write("en/index.md", "# Welcome\n\n- [Brush](brush.md)\n- [Prune](prune.md)\n");
    write("en/brush.md", "# Brush\n");
    write("en/prune.md", "# Prune\n");
    write("de/index.md", "# Willkommen\n\n- [Pinsel](brush.md)\n- [Schneiden](prune.md)\n");
    write("de/brush.md", "# Pinsel\n");
    const HelpBook german(QLocale(QStringLiteral("de_AT")), folder.path());
    QCOMPARE(german.title(QStringLiteral("brush")), QStringLiteral("Pinsel"));
    QVERIFY(german.url(QStringLiteral("brush")).path().endsWith(QStringLiteral("/de/brush.md")));
    QVERIFY(german.url(QStringLiteral("prune")).path().endsWith(QStringLiteral("/en/prune.md")));
    QVERIFY(german.url(QStringLiteral("none")).isEmpty());
    const HelpBook french(QLocale(QStringLiteral("fr_FR")), folder.path());
    QCOMPARE(french.title(QStringLiteral("index")), QStringLiteral("Welcome"));
}

void HelpTest::search_findsTitlesFirst()
{
    const HelpBook& book = help().book();
    QCOMPARE(book.find(QStringLiteral("PRUNE")).value(0), QStringLiteral("prune"));
    QVERIFY(book.find(QStringLiteral("prune")).contains(QStringLiteral("keys")));
    QCOMPARE(book.find(QStringLiteral("apical  domin")).value(0), QStringLiteral("architecture"));
    QVERIFY(
        !book.find(QStringLiteral("rush")).contains(QStringLiteral("brush"))); // Beginnings of words alone
    QVERIFY(book.find(QStringLiteral("zeppelin")).isEmpty());
}

void HelpTest::f1_opensThePageOfTheToolInHand_data()
{
    QTest::addColumn<int>("tool");
    for (const ActionId id : Actions::tools())
        QTest::newRow(qPrintable(action(id)->objectName())) << static_cast<int>(id);
}

void HelpTest::f1_opensThePageOfTheToolInHand()
{
    QFETCH(int, tool);
    const QAction* inHand = action(static_cast<ActionId>(tool));
    action(static_cast<ActionId>(tool))->trigger();
    QTest::keyClick(handle(), Qt::Key_F1);
    QTRY_VERIFY(help().isVisible());
    QCOMPARE(help().page(), inHand->objectName());
    // Another tool, another page; the same once more closes.
    action(ActionId::Brush)->trigger();
    QTest::keyClick(handle(), Qt::Key_F1);
    if (static_cast<ActionId>(tool) != ActionId::Brush) {
        QCOMPARE(help().page(), QStringLiteral("brush"));
        QTest::keyClick(handle(), Qt::Key_F1);
    }
    QTRY_VERIFY(!help().isVisible());
}

void HelpTest::f1InASheet_opensItsPage()
{
    action(ActionId::LeafSheet)->trigger();
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_VERIFY(workspace().sheet(2).isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(handle(), Qt::Key_F1);
    QTRY_VERIFY(help().isVisible());
    QCOMPARE(help().page(), QStringLiteral("leafSheet"));
    action(ActionId::LeafSheet)->trigger();
}

void HelpTest::button_opensAndEscapeCloses()
{
    BarButton* button = nullptr;
    for (auto* candidate : workspace().findChildren<BarButton*>()) {
        if (candidate->defaultAction() == action(ActionId::Help))
            button = candidate;
    }
    click(button);
    QVERIFY(help().isVisible());
    // Whole trees are framed in what the help leaves.
    QVERIFY(help().geometry().left() > workspace().width() / 3);
    QVERIFY(help().geometry().right() < workspace().width());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!help().isVisible());
    click(button);
    click(part<BarButton>("helpClose"));
    QVERIFY(!help().isVisible());
    QTRY_COMPARE(QApplication::focusWidget(), &workspace().viewport());
}

void HelpTest::links_leadToPagesAndBack()
{
    m_window->resize(1600, 900);
    action(ActionId::Help)->trigger();
    auto* shown = part<HelpPage>("helpPage");
    auto* list = part<QListWidget>("helpList");
    QCOMPARE(list->currentItem()->text(), QStringLiteral("Brush"));
    Q_EMIT shown->anchorClicked(QUrl(QStringLiteral("lasso.md")));
    QCOMPARE(help().page(), QStringLiteral("lasso"));
    QCOMPARE(list->currentItem()->text(), QStringLiteral("Lasso"));
    const QListWidgetItem* item = list->findItems(QStringLiteral("Prune"), Qt::MatchExactly).value(0);
    const QPoint place = list->visualItemRect(item).center();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, list->viewport()->mapTo(m_window.get(), place));
    QCOMPARE(help().page(), QStringLiteral("prune"));
    click(part<BarButton>("helpBack"));
    QCOMPARE(help().page(), QStringLiteral("lasso"));
    // The page that comes back is as well dressed.
    QTRY_VERIFY(shown->document()->size().width() <= shown->viewport()->width());
    QCOMPARE(shown->document()->begin().begin().fragment().charFormat().fontWeight(), int{QFont::Normal});
    click(part<BarButton>("helpBack"));
    QCOMPARE(help().page(), QStringLiteral("brush"));
}

void HelpTest::searchField_opensWhatItFinds()
{
    m_window->resize(1600, 900);
    action(ActionId::Help)->trigger();
    auto* search = part<QLineEdit>("helpSearch");
    click(search);
    QTest::keyClicks(search, QStringLiteral("bonsai"));
    QVERIFY(m_window->document().index().livingCount() == 1); // No letter was a key of the tree's
    auto* list = part<QListWidget>("helpList");
    QCOMPARE(list->item(0)->text(), QStringLiteral("Bend"));
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(help().page(), QStringLiteral("bend"));
    QTest::keyClicks(search, QStringLiteral("xyz"));
    QCOMPARE(list->count(), 1);
    QVERIFY(!(list->item(0)->flags() & Qt::ItemIsEnabled));
    search->clear();
    QVERIFY(list->count() > 15);
}

void HelpTest::keys_readAndFollowLinks()
{
    m_window->resize(1600, 900);
    action(ActionId::Help)->trigger();
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_VERIFY(help().isAncestorOf(QApplication::focusWidget()));
    auto* shown = part<HelpPage>("helpPage");
    for (int i = 0; i < 8 && QApplication::focusWidget() != shown; ++i)
        QTest::keyClick(handle(), Qt::Key_Tab);
    QTRY_COMPARE(QApplication::focusWidget(), shown);
    QTest::keyClick(handle(), Qt::Key_PageDown);
    QTRY_VERIFY(shown->verticalScrollBar()->value() > 0);
    // The first link plays the recipe, the second leads to another page.
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTest::keyClick(handle(), Qt::Key_Return);
    QTRY_COMPARE(help().page(), QStringLiteral("selectBud"));
    QTest::keyClick(handle(), Qt::Key_Left, Qt::AltModifier);
    QTRY_COMPARE(help().page(), QStringLiteral("brush"));
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_COMPARE(QApplication::focusWidget(), &workspace().viewport());
}

void HelpTest::narrowWindow_hasTheContentsInPlaceOfThePage()
{
    m_window->resize(1024, 700);
    action(ActionId::Help)->trigger();
    auto* list = part<QListWidget>("helpList");
    QTRY_VERIFY(!list->isVisible() && part<HelpPage>("helpPage")->isVisible());
    QTest::qWait(50); // Until all has its place
    click(part<BarButton>("helpContentsButton"));
    QTRY_VERIFY(list->isVisible() && !part<HelpPage>("helpPage")->isVisible());
    const QListWidgetItem* item = list->findItems(QStringLiteral("Width"), Qt::MatchExactly).value(0);
    list->scrollToItem(item);
    const QPoint place = list->visualItemRect(item).center();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, list->viewport()->mapTo(m_window.get(), place));
    QCOMPARE(help().page(), QStringLiteral("width"));
    QVERIFY(!list->isVisible() && part<HelpPage>("helpPage")->isVisible());
}

void HelpTest::playing_asksAboutUnsavedWorkAndLeavesNone()
{
    action(ActionId::GrowStep)->trigger();
    QTRY_VERIFY(m_window->isWindowModified() && !m_window->growRunner().isRunning());
    action(ActionId::Prune)->trigger();
    action(ActionId::Help)->trigger();
    auto* play = part<QPushButton>("helpPlay");
    answer(QMessageBox::Cancel);
    click(play);
    QVERIFY(!m_window->recipeRunner().isRunning());
    QCOMPARE(m_window->document().tree().step(), Step{1});

    answer(QMessageBox::Discard);
    click(play);
    QVERIFY(m_window->recipeRunner().isRunning());
    QVERIFY(help().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->recipeRunner().isRunning(), 60000);
    QCOMPARE(m_window->document().undoStack().count(), 5);
    // The program's own tree is nobody's work, until a hand has touched it.
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(m_window->document().undoStack().undoText(), QStringLiteral("Prune"));
    QVERIFY(action(ActionId::Prune)->isChecked());
    action(ActionId::Undo)->trigger();
    QVERIFY(m_window->isWindowModified());
}

void HelpTest::tour_goesOnByDoing()
{
    Tour& tour = m_window->help().tour();
    m_window->help().startFirstTour();
    QCOMPARE(tour.step(), 0);
    const auto base = workspace().viewport().camera().project(Vec3::Zero());
    const QPoint seedling = workspace().viewport().mapTo(m_window.get(), base->toPoint());
    drag(seedling, seedling - QPoint(0, 200));
    QTRY_COMPARE(tour.step(), 1);

    auto* slider = workspace().findChild<RadiusSlider*>();
    const QPoint knob = slider->mapTo(m_window.get(), slider->rect().center());
    drag(knob, knob + QPoint(0, 40));
    QTRY_COMPARE(tour.step(), 2);

    QTest::keyClick(handle(), Qt::Key_G, Qt::ShiftModifier);
    QTRY_COMPARE(tour.step(), 3);

    auto* time = workspace().growPopOut().findChild<QSlider*>(QStringLiteral("time"));
    QTRY_VERIFY(time->isVisible());
    const QPoint middle = time->mapTo(m_window.get(), time->rect().center());
    drag(middle, middle - QPoint(40, 0));
    QTRY_COMPARE(tour.step(), 4);

    const QPoint strip(300, m_window->height() - Viewport::kStripHeight / 2);
    drag(strip, strip + QPoint(200, 0));
    QTRY_COMPARE(tour.step(), 5);

    QTest::keyClick(handle(), Qt::Key_F1);
    QTRY_VERIFY(!tour.isRunning());
    QVERIFY(help().isVisible());
    QVERIFY(!tourButton("tourNext")->isVisible());
}

void HelpTest::tour_isSkippedAndNeverComesBack()
{
    Tour& tour = m_window->help().tour();
    QVERIFY(!tour.isRunning()); // A window alone begins none.
    m_window->help().startFirstTour();
    QVERIFY(tour.isRunning() && tourButton("tourSkip")->isVisible());
    click(tourButton("tourSkip"));
    QVERIFY(!tour.isRunning() && !tourButton("tourSkip")->isVisible());
    m_window->help().startFirstTour();
    QVERIFY(!tour.isRunning());

    // Who asks for it gets it again.
    action(ActionId::Help)->trigger();
    help().showPage(HelpBook::kIndex);
    click(part<QPushButton>("helpPlay"));
    QVERIFY(tour.isRunning() && !help().isVisible());
    for (int step = 0; step < tour.stepCount(); ++step) {
        QCOMPARE(tour.step(), step);
        click(tourButton("tourNext"));
    }
    QVERIFY(!tour.isRunning());
    m_window->help().startTour();
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!tour.isRunning());
}

void HelpTest::help_looksLikeThis()
{
    const auto shoot = [this](const char* name) {
        QTest::qWait(500);
        const QPixmap picture = m_window->screen()->grabWindow(m_window->winId());
        QVERIFY(picture.save(QString::fromLatin1(name)));
    };
    for (const QSize size : {QSize(1600, 1000), QSize(1024, 700)}) {
        m_window->resize(size);
        workspace().showHelp(true);
        for (const char* page : {"index", "brush", "keys", "bend"}) {
            help().showPage(QString::fromLatin1(page));
            const auto* shown = part<HelpPage>("helpPage");
            // Nothing is wider than the page.
            QTRY_VERIFY2(shown->document()->size().width() <= shown->viewport()->width() + 1, page);
            shoot(qPrintable(
                QStringLiteral("help-%1-%2.png").arg(QString::fromLatin1(page)).arg(size.width())));
        }
    }
}

int main(int argc, char** argv)
{
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-test"));
    HelpTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "HelpTest.moc"

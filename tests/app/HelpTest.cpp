// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HelpController.h"
#include "app/Tour.h"
#include "model/mesh/TreeCounts.h"
#include "panels/BrushPopOut.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPage.h"
#include "panels/HelpPanel.h"
#include "panels/RadiusSlider.h"
#include "panels/TimeSlider.h"
#include "panels/TourCard.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QFont>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QListWidgetItem>
#include <QMessageBox>
#include <QPixmap>
#include <QPoint>
#include <QPushButton>
#include <QScrollBar>
#include <QSize>
#include <QTest>
#include <QTextBlock>
#include <QUrl>
#include <QWidget>

#include <array>
#include <cmath>
#include <span>

using namespace espalier;

/// The user reads the help at the real window, and follows the tour.
class HelpTest : public test::WindowFixture {
    Q_OBJECT

public:
    HelpTest() : WindowFixture({1200, 700}) {}

private Q_SLOTS:
    void cleanup();
    void f1_opensThePageOfTheToolInHand_data();
    void f1_opensThePageOfTheToolInHand();
    void f1InASheet_opensItsPage();
    void button_opensAndEscapeCloses();
    void escape_cancelsTheStrokeBeforeItClosesHelpOrTour();
    void links_leadToPagesAndBack();
    void searchField_opensWhatItFinds();
    void keys_readAndFollowLinks();
    void narrowWindow_hasTheContentsInPlaceOfThePage();
    void playing_setsOnesOwnTreeAside();
    void wayBack_isThereWhileTheRecipePlays();
    void wayBack_isNotOfferedForASeedling();
    void tour_leadsToATreeAndGoesOnByDoing();
    void tour_waitsUntilTheHandLetsGo();
    void tour_cardsAreOpaqueAndKeepClearOfBars();
    void tour_givesBackTheBrushOfAUserWhoSkipsIt();
    void tour_showsADrawnTreeAndGoesOn();
    void tour_isSkippedAndNeverComesBack();
    void help_looksLikeThis();

private:
    HelpPanel& help() { return workspace().help(); }
    template <class Widget>
    Widget* part(const char* name)
    {
        return help().findChild<Widget*>(QString::fromLatin1(name));
    }
    QPushButton* tourButton(const char* name)
    {
        return workspace().findChild<QPushButton*>(QString::fromLatin1(name));
    }
    QPushButton* wayBack() { return workspace().findChild<QPushButton*>(QStringLiteral("wayBack")); }
    void growSteps(int count);
    TourCard& card() { return *workspace().findChild<TourCard*>(); }
    void click(QWidget* widget);
    void drag(const QPoint& from, const QPoint& to) { drag(std::array{from, to}); }
    void drag(std::span<const QPoint> way);
};

void HelpTest::cleanup()
{
    m_window->help().tour().stop();
    workspace().showHelp(false);
    m_window->recipeRunner().stop();
    WindowFixture::cleanup();
}

void HelpTest::click(QWidget* widget)
{
    QVERIFY(widget && widget->isVisible());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, widget->mapTo(m_window.get(), widget->rect().center()));
    QCoreApplication::processEvents();
}

void HelpTest::drag(std::span<const QPoint> way)
{
    constexpr int kMoves = 15;
    QTest::mousePress(handle(), Qt::LeftButton, {}, way.front());
    for (std::size_t leg = 1; leg < way.size(); ++leg) {
        for (int i = 1; i <= kMoves; ++i) {
            QTest::mouseMove(handle(), way[leg - 1] + (way[leg] - way[leg - 1]) * i / kMoves);
            QTest::qWait(20);
        }
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, way.back());
    QCoreApplication::processEvents();
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
    // Another tool opens another page; a second press closes the help.
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
    // Whole trees are framed in the part that the help leaves free.
    QVERIFY(help().geometry().left() > workspace().width() / 3);
    QVERIFY(help().geometry().right() < workspace().width());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!help().isVisible());
    click(button);
    click(part<BarButton>("helpClose"));
    QVERIFY(!help().isVisible());
    QTRY_COMPARE(QApplication::focusWidget(), &workspace().viewport());
}

void HelpTest::escape_cancelsTheStrokeBeforeItClosesHelpOrTour()
{
    for (const bool isTour : {false, true}) {
        if (isTour)
            m_window->help().startTour();
        else
            action(ActionId::Help)->trigger();
        const auto isOpen = [&] { return isTour ? m_window->help().tour().isRunning() : help().isVisible(); };
        QVERIFY(isOpen());
        const QPoint from = at(0.0F, 0.05F);
        QTest::mousePress(handle(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= 8; ++i) {
            QTest::mouseMove(handle(), from - QPoint(0, 6 * i));
            QTest::qWait(20);
        }
        QVERIFY(viewport().isGestureActive());
        QTest::keyClick(handle(), Qt::Key_Escape);
        QVERIFY(!viewport().isGestureActive());
        QVERIFY(isOpen());
        QTest::mouseRelease(handle(), Qt::LeftButton, {}, from - QPoint(0, 48));
        QCOMPARE(m_window->document().undoStack().count(), 0);
        QTest::keyClick(handle(), Qt::Key_Escape);
        QVERIFY(!isOpen());
    }
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
    list->scrollToItem(item);
    const QPoint place = list->visualItemRect(item).center();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, list->viewport()->mapTo(m_window.get(), place));
    QCOMPARE(help().page(), QStringLiteral("prune"));
    click(part<BarButton>("helpBack"));
    QCOMPARE(help().page(), QStringLiteral("lasso"));
    // The page has its style again after going back.
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
    QTest::keyClicks(search, QStringLiteral("stiffness"));
    QVERIFY(m_window->document().index().livingCount() == 1); // No letter was used as a key of the tree
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
    QTest::qWait(50); // Until the layout is complete
    click(part<BarButton>("helpContentsButton"));
    QTRY_VERIFY(list->isVisible() && !part<HelpPage>("helpPage")->isVisible());
    const QListWidgetItem* item = list->findItems(QStringLiteral("Width"), Qt::MatchExactly).value(0);
    list->scrollToItem(item);
    const QPoint place = list->visualItemRect(item).center();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, list->viewport()->mapTo(m_window.get(), place));
    QCOMPARE(help().page(), QStringLiteral("width"));
    QVERIFY(!list->isVisible() && part<HelpPage>("helpPage")->isVisible());
}

void HelpTest::growSteps(int count)
{
    for (int i = 0; i < count; ++i) {
        action(ActionId::GrowStep)->trigger();
        QTRY_COMPARE(m_window->document().undoStack().index(), i + 1);
        QTRY_VERIFY(!m_window->growRunner().isRunning());
    }
}

void HelpTest::playing_setsOnesOwnTreeAside()
{
    growSteps(3);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(m_window->document().undoStack().index(), 2);
    const test::DocumentState own(m_window->document());
    action(ActionId::Prune)->trigger();
    action(ActionId::Help)->trigger();
    // Nothing is asked, since nothing is lost.
    click(part<QPushButton>("helpPlay"));
    QVERIFY(m_window->recipeRunner().isRunning());
    QVERIFY(wayBack()->isVisible());
    QVERIFY(help().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->recipeRunner().isRunning(), 60000);
    QCOMPARE(m_window->document().undoStack().count(), 5);
    // The program's own tree is not an unsaved change until the user edits it.
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(m_window->document().undoStack().undoText(), QStringLiteral("Prune"));
    QVERIFY(action(ActionId::Prune)->isChecked());

    click(wayBack());
    QVERIFY(!wayBack()->isVisible());
    QCOMPARE(test::differenceFrom(own, m_window->document()), QString());
    QVERIFY(m_window->isWindowModified());
    QCOMPARE(m_window->document().undoStack().count(), 3);
    // What was undone can be redone, and all of it undone.
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(m_window->document().tree().step(), Step{3});
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(m_window->document().tree().step(), Step{0});
    QVERIFY(!m_window->isWindowModified());
}

void HelpTest::wayBack_isThereWhileTheRecipePlays()
{
    growSteps(1);
    const test::DocumentState own(m_window->document());
    action(ActionId::Prune)->trigger();
    action(ActionId::Help)->trigger();
    click(part<QPushButton>("helpPlay"));
    QVERIFY(m_window->recipeRunner().isRunning());
    click(wayBack());
    QVERIFY(!m_window->recipeRunner().isRunning());
    QCOMPARE(test::differenceFrom(own, m_window->document()), QString());
    // A tree of a recipe that the user has changed is asked about.
    click(part<QPushButton>("helpPlay"));
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->recipeRunner().isRunning(), 60000);
    action(ActionId::Undo)->trigger();
    QTRY_VERIFY(m_window->isWindowModified());
    const Tree changed = m_window->document().tree();
    answer(QMessageBox::Cancel);
    click(wayBack());
    QVERIFY(m_window->document().tree() == changed);
    answer(QMessageBox::Discard);
    click(wayBack());
    QCOMPARE(test::differenceFrom(own, m_window->document()), QString());
}

void HelpTest::wayBack_isNotOfferedForASeedling()
{
    action(ActionId::Prune)->trigger();
    action(ActionId::Help)->trigger();
    click(part<QPushButton>("helpPlay"));
    QVERIFY(m_window->recipeRunner().isRunning());
    QVERIFY(!wayBack()->isVisible());
}

void HelpTest::tour_leadsToATreeAndGoesOnByDoing()
{
    Tour& tour = m_window->help().tour();
    m_window->help().startFirstTour();
    QCOMPARE(tour.step(), 0);
    const TreeIndex& index = m_window->document().index();
    const Tree& tree = m_window->document().tree();

    // A trunk: one axis.
    const auto base = workspace().viewport().mainCamera().project(Vec3::Zero());
    const QPoint seedling = workspace().viewport().mapTo(m_window.get(), base->toPoint());
    drag(seedling, seedling - QPoint(0, 260));
    QTRY_COMPARE(tour.step(), 1);
    QVERIFY(treeBounds(tree, index).sizes().x() < 0.1F * treeBounds(tree, index).sizes().y());

    for (const QPoint& reach : {QPoint(-120, -90), QPoint(120, -80), QPoint(-60, -150)}) {
        QCOMPARE(tour.step(), 1);
        const QPoint from = seedling - QPoint(0, 160);
        drag(from, from + reach);
    }
    QTRY_COMPARE(tour.step(), 2);

    auto* slider = workspace().findChild<RadiusSlider*>();
    const QPoint knob = slider->mapTo(m_window.get(), QPoint(slider->width() / 2, slider->height() - 8));
    drag(knob, knob - QPoint(0, 100));
    QTRY_COMPARE(tour.step(), 3);

    const QPoint fork = seedling - QPoint(0, 170);
    drag(std::array{fork, fork + QPoint(-100, -70), fork + QPoint(-40, -140), fork + QPoint(60, -130),
                    fork + QPoint(110, -70)});
    QTRY_COMPARE(tour.step(), 4);
    // A tree, not a shrub: the lower part of the trunk is bare, and what it carries is wide and dense.
    const Box3 bounds = treeBounds(tree, index);
    std::size_t low = 0;
    std::size_t high = 0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        const Vec3 node = index.nodePosition(id);
        const bool isLow = node.y() < 0.3F * bounds.max().y();
        if (!isLow)
            ++high;
        else if (std::hypot(node.x(), node.z()) > 0.05F * bounds.max().y())
            ++low;
    }
    QVERIFY2(20 * low < high, qPrintable(QString::number(low)));
    QVERIFY2(high > 150, qPrintable(QString::number(high)));
    QVERIFY(bounds.sizes().x() > 0.6F * bounds.sizes().y());

    QTest::keyClick(handle(), Qt::Key_G, Qt::ShiftModifier);
    QTRY_COMPARE(tour.step(), 5);

    auto* time = workspace().growPopOut().findChild<TimeSlider*>(QStringLiteral("time"));
    QTRY_VERIFY(time->isVisible());
    const QPoint held = time->mapTo(m_window.get(), time->handlePlace().toPoint());
    drag(held, held - QPoint(40, 0));
    QTRY_COMPARE(tour.step(), 6);

    const QPoint strip(300, m_window->height() - Viewport::kStripHeight / 2);
    drag(strip, strip + QPoint(200, 0));
    QTRY_COMPARE(tour.step(), 7);

    QTest::keyClick(handle(), Qt::Key_S);
    QTRY_COMPARE(tour.step(), 8);

    QTest::keyClick(handle(), Qt::Key_F1);
    QTRY_VERIFY(!tour.isRunning());
    QVERIFY(help().isVisible());
    QVERIFY(!tourButton("tourNext")->isVisible());
}

void HelpTest::tour_waitsUntilTheHandLetsGo()
{
    Tour& tour = m_window->help().tour();
    tour.start(2);
    auto* slider = workspace().findChild<RadiusSlider*>();
    const QPoint knob = slider->mapTo(m_window.get(), slider->rect().center());
    QTest::mousePress(handle(), Qt::LeftButton, {}, knob);
    for (int i = 1; i <= 10; ++i)
        QTest::mouseMove(handle(), knob - QPoint(0, 4 * i));
    QTest::qWait(1500);
    QCOMPARE(tour.step(), 2);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, knob - QPoint(0, 40));
    QTRY_COMPARE(tour.step(), 3);

    // Likewise a turn of the camera.
    tour.start(6);
    const QPoint strip(300, m_window->height() - Viewport::kStripHeight / 2);
    QTest::mousePress(handle(), Qt::LeftButton, {}, strip);
    for (int i = 1; i <= 20; ++i)
        QTest::mouseMove(handle(), strip + QPoint(10 * i, 0));
    QTest::qWait(1500);
    QCOMPARE(tour.step(), 6);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, strip + QPoint(200, 0));
    QTRY_COMPARE(tour.step(), 7);
}

void HelpTest::tour_cardsAreOpaqueAndKeepClearOfBars()
{
    Tour& tour = m_window->help().tour();
    for (const QSize size : {QSize(920, 680), QSize(1200, 700), QSize(1600, 1000)}) {
        m_window->resize(size);
        QTRY_COMPARE(workspace().size(), size);
        for (int step = 0; step < tour.stepCount(); ++step) {
            tour.start(step);
            QTest::qWait(20);
            QVERIFY(card().isVisible() && workspace().rect().contains(card().geometry()));
            for (const Bar* bar : workspace().findChildren<Bar*>(Qt::FindDirectChildrenOnly)) {
                if (bar == &card() || !bar->isVisible())
                    continue;
                const QString where = QStringLiteral("card %1 at %2 px covers %3")
                                          .arg(step + 1)
                                          .arg(size.width())
                                          .arg(QLatin1String(bar->metaObject()->className()));
                QVERIFY2(!bar->geometry().intersects(card().geometry()), qPrintable(where));
            }
            QImage picture(card().size(), QImage::Format_ARGB32_Premultiplied);
            picture.fill(Qt::transparent);
            card().render(&picture, {}, {}, QWidget::DrawChildren);
            QCOMPARE(picture.pixelColor(picture.width() / 2, 8).alpha(), 255);
        }
    }
    tour.stop();
}

void HelpTest::tour_givesBackTheBrushOfAUserWhoSkipsIt()
{
    m_window->viewSettings().set(&ViewValues::brushRadius, 0.4);
    m_window->help().startTour();
    QCOMPARE(m_window->viewSettings().values().brushRadius, 0.0);
    click(tourButton("tourSkip"));
    QCOMPARE(m_window->viewSettings().values().brushRadius, 0.4);
}

void HelpTest::tour_showsADrawnTreeAndGoesOn()
{
    Tour& tour = m_window->help().tour();
    tour.start(7);
    click(tourButton("tourWatch"));
    QTRY_VERIFY(m_window->recipeRunner().isRunning());
    QVERIFY(!tour.isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->document().index().livingCount() > 100, 60'000);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!m_window->recipeRunner().isRunning());
    QTRY_COMPARE(tour.step(), 8);
    tour.stop();
}

void HelpTest::tour_isSkippedAndNeverComesBack()
{
    Tour& tour = m_window->help().tour();
    QVERIFY(!tour.isRunning()); // A window does not start the tour by itself
    m_window->help().startFirstTour();
    QVERIFY(tour.isRunning() && tourButton("tourSkip")->isVisible());
    click(tourButton("tourSkip"));
    QVERIFY(!tour.isRunning() && !tourButton("tourSkip")->isVisible());
    m_window->help().startFirstTour();
    QVERIFY(!tour.isRunning());

    // The action starts the tour again.
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

static const test::TestClass<HelpTest> helpTest;

#include "HelpTest.moc"

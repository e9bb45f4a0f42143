// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowGesture.h"
#include "panels/GrowPopOut.h"
#include "panels/HistoryPanel.h"
#include "panels/Notice.h"
#include "panels/TimeSlider.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCoreApplication>
#include <QLabel>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPoint>
#include <QPushButton>
#include <QRect>
#include <QTest>
#include <QUndoView>

#include <limits>

using namespace espalier;

/// The user lets the tree grow, and goes back in time.
class GrowingTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void holdingGrow_isOneUndoStep();
    void growTool_growsWhileTheHandHolds();
    void manySteps_areStoppedByEscape();
    void growthAtTheCeiling_asksBeforeItGoesOn();
    void strokeDuringGrowth_endsIt();
    void newTreeDuringGrowth_isAskedAbout();
    void timeSlider_ungrowsAndComesBack();
    void timeSlider_isGrabbedWhereItIsHeld();
    void timeSlider_growsOnlyWhenPulled();
    void pressBesideTheTimeSlider_growsNothing();
    void escape_takesTheTimeSliderBack();
    void timeSliderFarFromTheTrack_isFine();
    void timeSlider_namesTheMoment();
    void play_showsTheHistoryAgain();
    void history_goesWhereItIsClicked();

private:
    TimeSlider& timeSlider();
    /// Presses the slider at @p from, px, and moves the pointer to places beside that one.
    void drag(const QPointF& from, const std::vector<QPointF>& by, Qt::KeyboardModifiers modifiers = {});
    void letGo(const QPointF& at);
};

void GrowingTest::holdingGrow_isOneUndoStep()
{
    QTest::keyClick(handle(), Qt::Key_G, Qt::ShiftModifier);
    auto* button = m_window->workspace().growPopOut().findChild<QPushButton*>(QStringLiteral("holdToGrow"));
    QTRY_VERIFY(button->isVisible());
    const QPoint place = button->mapTo(m_window.get(), button->rect().center());
    QTest::mousePress(handle(), Qt::LeftButton, {}, place);
    QTRY_VERIFY(m_window->document().tree().step() >= 4);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, place);
    QCoreApplication::processEvents();
    QVERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().undoStack().count(), 1);
    const Step grown = m_window->document().tree().step();
    QTest::qWait(200);
    QCOMPARE(m_window->document().tree().step(), grown);

    QTest::keyClick(handle(), Qt::Key_G);
    QTRY_COMPARE(m_window->document().undoStack().count(), 2);
    QCOMPARE(m_window->document().tree().step(), grown + 1);
}

void GrowingTest::growthAtTheCeiling_asksBeforeItGoesOn()
{
    GrowRunner& runner = m_window->growRunner();
    runner.limitCeiling(2'000);
    runner.run(1000);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), 30'000);
    const auto& notice = m_window->workspace().notice();
    const std::uint32_t grown = m_window->document().tree().size();
    QVERIFY(grown >= 2'000 && grown < 10'000);
    QVERIFY2(notice.text().contains(QStringLiteral("Growth has stopped")), qPrintable(notice.text()));
    QCOMPARE(m_window->document().undoStack().count(), 1);
    QTest::mouseClick(notice.findChild<QPushButton*>(), Qt::LeftButton);
    const Step before = m_window->document().tree().step();
    runner.run(2);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), 30'000);
    QCOMPARE(m_window->document().tree().step(), before + 2);
    runner.limitCeiling(std::numeric_limits<std::uint32_t>::max());
    m_window->document().undoStack().setClean();
}

void GrowingTest::growTool_growsWhileTheHandHolds()
{
    action(ActionId::Grow)->trigger();
    QTest::mousePress(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QTRY_VERIFY(m_window->document().tree().step() >= 3);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QCoreApplication::processEvents();
    QCOMPARE(m_window->document().undoStack().count(), 1);

    QTest::mousePress(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QTest::qWait(200);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QCoreApplication::processEvents();
    QVERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().undoStack().count(), 1);
}

void GrowingTest::manySteps_areStoppedByEscape()
{
    m_window->growRunner().run(1000);
    QTRY_VERIFY(m_window->document().tree().step() >= 3);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().tree().step(), Step{0});

    m_window->growRunner().run(3);
    QTRY_VERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().tree().step(), Step{3});
    QCOMPARE(m_window->document().undoStack().count(), 1);
}

void GrowingTest::strokeDuringGrowth_endsIt()
{
    TreeDocument& document = m_window->document();
    m_window->growRunner().run(1000);
    QTRY_VERIFY(document.journal().size() > 2);
    brush();
    QVERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(document.undoStack().count(), 2);
    const Tree whole = document.tree();
    document.undoStack().undo();
    document.undoStack().undo();
    QCOMPARE(document.index().livingCount(), 1U);
    document.undoStack().redo();
    document.undoStack().redo();
    QVERIFY(document.tree() == whole);
}

void GrowingTest::newTreeDuringGrowth_isAskedAbout()
{
    m_window->growRunner().run(1000);
    QTRY_VERIFY(m_window->document().tree().step() >= 3);
    answer(QMessageBox::Cancel);
    action(ActionId::New)->trigger();
    QVERIFY(m_window->growRunner().isRunning());
    QVERIFY(m_window->document().tree().step() >= 3);
    answer(QMessageBox::Discard);
    action(ActionId::New)->trigger();
    QVERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().tree().size(), 1U);
    QVERIFY(!m_window->document().undoStack().canUndo());
}

TimeSlider& GrowingTest::timeSlider()
{
    if (!action(ActionId::Grow)->isChecked())
        action(ActionId::Grow)->trigger();
    return *m_window->findChild<TimeSlider*>(QStringLiteral("time"));
}

void GrowingTest::drag(const QPointF& from, const std::vector<QPointF>& by, Qt::KeyboardModifiers modifiers)
{
    const TimeSlider& slider = timeSlider();
    const auto place = [&](const QPointF& point) { return slider.mapTo(m_window.get(), point.toPoint()); };
    QTest::mousePress(handle(), Qt::LeftButton, modifiers, place(from));
    for (const QPointF& way : by) {
        QMouseEvent moved(QEvent::MouseMove, QPointF(place(from + way)),
                          m_window->mapToGlobal(QPointF(place(from + way))), Qt::NoButton, Qt::LeftButton,
                          modifiers);
        QCoreApplication::sendEvent(handle(), &moved);
    }
}

void GrowingTest::letGo(const QPointF& at)
{
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, timeSlider().mapTo(m_window.get(), at.toPoint()));
    QCoreApplication::processEvents();
}

void GrowingTest::timeSlider_ungrowsAndComesBack()
{
    brush();
    TreeDocument& document = m_window->document();
    const std::uint32_t grown = document.index().livingCount();
    const auto end = static_cast<int>(document.journal().size());
    TimeSlider& slider = timeSlider();
    QVERIFY(slider.isVisible());
    QCOMPARE(slider.value(), end);
    const QPointF way = slider.placeOf(end / 2) - slider.handlePlace();
    drag(slider.handlePlace(), {0.5 * way, way});
    QVERIFY(document.index().livingCount() < grown);
    QVERIFY(std::abs(static_cast<int>(document.journal().size()) - end / 2) <= 1);
    letGo(slider.handlePlace());
    QCOMPARE(document.undoStack().count(), 2);
    // Keys go on by single steps, and not beyond the present.
    slider.setFocus(Qt::TabFocusReason);
    const auto here = static_cast<int>(document.journal().size());
    QTest::keyClick(handle(), Qt::Key_Right);
    QCOMPARE(static_cast<int>(document.journal().size()), here + 1);
    QTest::keyClick(handle(), Qt::Key_End);
    QTest::keyClick(handle(), Qt::Key_Right);
    QCOMPARE(static_cast<int>(document.journal().size()), end);
    QVERIFY(document.future().empty());
    QCOMPARE(document.index().livingCount(), grown);
}

void GrowingTest::timeSlider_isGrabbedWhereItIsHeld()
{
    brush();
    const TreeDocument& document = m_window->document();
    const auto end = document.journal().size();
    const TimeSlider& slider = timeSlider();
    for (const double off : {-9.0, 9.0}) {
        const QPointF held = slider.handlePlace() + QPointF(off, 0.0);
        drag(held, {{0.0, 1.0}, {0.0, 0.0}});
        QCOMPARE(document.journal().size(), end);
        letGo(held);
        QCOMPARE(document.undoStack().count(), 1);
    }
}

void GrowingTest::timeSlider_growsOnlyWhenPulled()
{
    brush();
    TreeDocument& document = m_window->document();
    const auto end = document.journal().size();
    const TimeSlider& slider = timeSlider();
    const QPointF held = slider.handlePlace();
    drag(held, {{10.0, 0.0}, {20.0, 0.0}});
    QCOMPARE(document.journal().size(), end);
    letGo(held + QPointF(20.0, 0.0));
    QCOMPARE(document.undoStack().count(), 1);
    drag(held, {{20.0, 0.0}, {33.0, 0.0}});
    const auto grown = document.journal().size();
    QVERIFY(grown > end && grown <= end + 3);
    letGo(held + QPointF(33.0, 0.0));
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QCOMPARE(document.journal().size(), end);
}

void GrowingTest::pressBesideTheTimeSlider_growsNothing()
{
    brush();
    TreeDocument& document = m_window->document();
    const auto end = document.journal().size();
    const TimeSlider& slider = timeSlider();
    const QPointF beside = slider.handlePlace() + QPointF(40.0, 0.0);
    drag(beside, {});
    letGo(beside);
    QCOMPARE(document.journal().size(), end);
    QCOMPARE(document.undoStack().count(), 1);
    // In the past it goes a part of the way, and what was undone can still be redone.
    const QPointF begin = slider.placeOf(0);
    drag(begin, {});
    letGo(begin);
    QVERIFY(document.journal().size() < end);
    QCOMPARE(document.journal().size() + document.future().size(), end);
}

void GrowingTest::escape_takesTheTimeSliderBack()
{
    brush();
    TreeDocument& document = m_window->document();
    const Tree before = document.tree();
    const auto end = static_cast<int>(document.journal().size());
    const TimeSlider& slider = timeSlider();
    const QPointF held = slider.handlePlace();
    const QPointF way = slider.placeOf(end / 3) - held;
    drag(held, {0.5 * way, way});
    QVERIFY(!document.future().empty());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(document.tree() == before);
    QVERIFY(!m_window->isBusy());
    // The pointer that is still down moves nothing more.
    QTest::mouseMove(handle(), slider.mapTo(m_window.get(), (held + 0.7 * way).toPoint()));
    letGo(held + 0.7 * way);
    QVERIFY(document.tree() == before);
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(slider.value(), end);
}

void GrowingTest::timeSliderFarFromTheTrack_isFine()
{
    makeTree();
    TreeDocument& document = m_window->document();
    const auto end = static_cast<int>(document.journal().size());
    const TimeSlider& slider = timeSlider();
    const QPointF held = slider.handlePlace();
    const auto travelled = [&](const std::vector<QPointF>& by, Qt::KeyboardModifiers modifiers) {
        drag(held, by, modifiers);
        const int way = end - static_cast<int>(document.journal().size());
        QTest::keyClick(handle(), Qt::Key_Escape);
        letGo(held);
        return way;
    };
    const int near = travelled({{-40.0, 0.0}}, {});
    const int far = travelled({{0.0, 160.0}, {-40.0, 160.0}}, {});
    const int shifted = travelled({{-40.0, 0.0}}, Qt::ShiftModifier);
    QVERIFY2(near >= 5 && far <= 1 && shifted <= 2,
             qPrintable(QStringLiteral("%1 %2 %3").arg(near).arg(far).arg(shifted)));
}

void GrowingTest::timeSlider_namesTheMoment()
{
    brush();
    const TreeDocument& document = m_window->document();
    const auto end = static_cast<int>(document.journal().size());
    const TimeSlider& slider = timeSlider();
    const auto* step = m_window->findChild<QLabel*>(QStringLiteral("timeStep"));
    const auto* title = m_window->findChild<QLabel*>(QStringLiteral("timeTitle"));
    QCOMPARE(step->text(), QStringLiteral("Moment %1 of %1").arg(end));
    QCOMPARE(title->text(), QStringLiteral("Brush Stroke"));
    const QPointF held = slider.handlePlace();
    drag(held, {slider.placeOf(0) - held});
    QCOMPARE(step->text(), QStringLiteral("Moment 0 of %1").arg(end));
    QCOMPARE(title->text(), QStringLiteral("Seedling"));
    letGo(slider.placeOf(0));
}

void GrowingTest::play_showsTheHistoryAgain()
{
    brush();
    TreeDocument& document = m_window->document();
    const Tree grown = document.tree();
    const int commands = document.undoStack().count();
    action(ActionId::Grow)->trigger();
    auto* play = m_window->findChild<QPushButton*>(QStringLiteral("playTime"));
    QTest::mouseClick(play, Qt::LeftButton);
    QVERIFY(play->isChecked());
    QVERIFY(document.index().livingCount() < 10);
    QTRY_VERIFY_WITH_TIMEOUT(!play->isChecked(), 20000);
    QVERIFY(document.tree() == grown);
    QCOMPARE(document.undoStack().count(), commands);
}

void GrowingTest::history_goesWhereItIsClicked()
{
    brush();
    brush(1.0F, 1.4F, 0.4F);
    TreeDocument& document = m_window->document();
    QCOMPARE(document.undoStack().count(), 2);
    action(ActionId::History)->trigger();
    auto* list = m_window->findChild<QUndoView*>(QStringLiteral("history"));
    QVERIFY(list->isVisible());
    const auto click = [&](int row) {
        const QRect place = list->visualRect(list->model()->index(row, 0));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, place.center());
    };
    click(0);
    QCOMPARE(document.index().livingCount(), 1U);
    click(2);
    QCOMPARE(document.undoStack().index(), 2);
    QVERIFY(document.index().livingCount() > 1);
    action(ActionId::History)->trigger();
    QVERIFY(!list->isVisible());
}

static const test::TestClass<GrowingTest> growingTest;

#include "GrowingTest.moc"

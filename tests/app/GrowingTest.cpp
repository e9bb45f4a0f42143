// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowGesture.h"
#include "panels/GrowPopOut.h"
#include "panels/HistoryPanel.h"
#include "panels/Notice.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPoint>
#include <QPushButton>
#include <QRect>
#include <QSlider>
#include <QTest>
#include <QUndoView>

using namespace espalier;

/// The user lets the tree grow, and goes back in time.
class GrowingTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void holdingGrow_isOneUndoStep();
    void growTool_growsWhileTheHandHolds();
    void manySteps_areStoppedByEscape();
    void strokeDuringGrowth_endsIt();
    void newTreeDuringGrowth_isAskedAbout();
    void timeSlider_ungrowsAndGrowsOn();
    void play_showsTheHistoryAgain();
    void history_goesWhereItIsClicked();
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

void GrowingTest::timeSlider_ungrowsAndGrowsOn()
{
    brush();
    TreeDocument& document = m_window->document();
    const std::uint32_t grown = document.index().livingCount();
    const auto end = static_cast<int>(document.journal().size());
    action(ActionId::Grow)->trigger();
    auto* slider = m_window->findChild<QSlider*>(QStringLiteral("time"));
    QVERIFY(slider->isVisible());
    QCOMPARE(slider->value(), end);
    const auto place = [&](int value) {
        const double share = static_cast<double>(value) / slider->maximum();
        return QPoint(static_cast<int>(8 + share * (slider->width() - 16)), slider->height() / 2);
    };
    QTest::mousePress(slider, Qt::LeftButton, {}, place(end));
    for (int value = end; value >= end / 2; --value)
        QTest::mouseMove(slider, place(value));
    QVERIFY(document.index().livingCount() < grown);
    QVERIFY(!document.future().empty());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, place(end / 2));
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QCOMPARE(document.index().livingCount(), grown);
    QCOMPARE(slider->value(), end);
    // Beyond the present it grows.
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(document.index().livingCount() > grown);
    QCOMPARE(static_cast<int>(document.journal().size()), end + 1);
    document.undoStack().undo();
    QCOMPARE(document.index().livingCount(), grown);
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

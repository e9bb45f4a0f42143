// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HeldToolKey.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QAction>
#include <QPoint>
#include <QPointingDevice>
#include <QTest>

#include <cmath>

using namespace espalier;

/// What drawing programs have taught hands to expect, at the real window.
class ComfortsTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void heldKey_takesAToolAndGivesTheFormerBack();
    void tappedKey_takesAToolForGood();
    void heldKey_waitsForTheEndOfTheGesture();
    void shiftDrag_changesTheRadiusInPlace();
    void fingersThatTap_undoRedoAndHide();

private:
    bool hasTool(ActionId id) { return action(id)->isChecked(); }
    void tap(int fingers);
};

void ComfortsTest::heldKey_takesAToolAndGivesTheFormerBack()
{
    makeTree();
    const std::uint32_t before = m_window->document().index().livingCount();
    QTest::keyPress(handle(), Qt::Key_P);
    QTRY_VERIFY(hasTool(ActionId::Prune));
    QTest::qWait(HeldToolKey::kHeld + 50);
    const QPoint branch = at(0.2F, 1.03F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, branch - QPoint(0, 25));
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(handle(), branch + QPoint(0, 10 * i - 25));
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, branch + QPoint(0, 25));
    QTRY_VERIFY(m_window->document().index().livingCount() < before);
    QVERIFY(hasTool(ActionId::Prune));
    QTest::keyRelease(handle(), Qt::Key_P);
    QTRY_VERIFY(hasTool(ActionId::Brush));
}

void ComfortsTest::tappedKey_takesAToolForGood()
{
    QTest::keyClick(handle(), Qt::Key_P);
    QTRY_VERIFY(hasTool(ActionId::Prune));
    // A key that is held only for long, and not used, gives the tool back as well.
    QTest::keyPress(handle(), Qt::Key_B, Qt::ShiftModifier);
    QTRY_VERIFY(hasTool(ActionId::Bend));
    QTest::qWait(HeldToolKey::kHeldUnused + 50);
    QTest::keyRelease(handle(), Qt::Key_B, Qt::ShiftModifier);
    QTRY_VERIFY(hasTool(ActionId::Prune));
}

void ComfortsTest::heldKey_waitsForTheEndOfTheGesture()
{
    makeTree();
    action(ActionId::Prune)->trigger();
    QTest::keyPress(handle(), Qt::Key_B);
    QTRY_VERIFY(hasTool(ActionId::Brush));
    const QPoint from = at(0.0F, 1.5F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    QTest::qWait(HeldToolKey::kHeld + 50);
    QTest::keyRelease(handle(), Qt::Key_B);
    for (int i = 1; i <= 10; ++i) {
        QTest::mouseMove(handle(), from - QPoint(0, 4 * i));
        QTest::qWait(20);
    }
    QVERIFY(hasTool(ActionId::Brush) && viewport().isGestureActive());
    const int steps = m_window->document().undoStack().count();
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from - QPoint(0, 40));
    QTRY_VERIFY(hasTool(ActionId::Prune));
    QCOMPARE(m_window->document().undoStack().count(), steps + 1);
}

void ComfortsTest::shiftDrag_changesTheRadiusInPlace()
{
    const auto radius = [&] { return m_window->viewSettings().values().brushRadius; };
    const double before = radius();
    const double perMetre =
        static_cast<double>(viewport().camera().pixelsPerMetre(viewport().camera().depth(Vec3::Zero())));
    const QPoint from = at(0.5F, 1.0F);
    const auto drag = [&](int by) {
        QTest::mousePress(handle(), Qt::LeftButton, Qt::ShiftModifier, from);
        for (int i = 1; i <= 10; ++i) {
            QTest::mouseMove(handle(), from + QPoint(by * i / 10, 0));
            QTest::qWait(10);
        }
    };
    drag(40);
    QTest::mouseRelease(handle(), Qt::LeftButton, Qt::ShiftModifier, from + QPoint(40, 0));
    QVERIFY2(std::abs(radius() - before - 40.0 / perMetre) < 0.02, qPrintable(QString::number(radius())));
    drag(-500);
    QCOMPARE(radius(), 0.0);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, Qt::ShiftModifier, from - QPoint(500, 0));
    QVERIFY(std::abs(radius() - before - 40.0 / perMetre) < 0.02);
    // Nothing was drawn.
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QCOMPARE(m_window->document().index().livingCount(), 1U);
}

void ComfortsTest::tap(int fingers)
{
    const QPoint first = at(0.3F, 1.2F);
    const auto place = [&](int finger) { return first + QPoint(50 * finger, 0); };
    for (int i = 0; i < fingers; ++i) {
        auto event = QTest::touchEvent(handle(), m_screen);
        for (int before = 0; before < i; ++before)
            event.stationary(before);
        event.press(i, place(i), handle());
    }
    for (int i = 0; i < fingers; ++i) {
        auto event = QTest::touchEvent(handle(), m_screen);
        event.release(i, place(i), handle());
        for (int after = i + 1; after < fingers; ++after)
            event.stationary(after);
    }
}

void ComfortsTest::fingersThatTap_undoRedoAndHide()
{
    makeTree();
    TreeDocument& document = m_window->document();
    const int steps = document.undoStack().index();
    const Tree tree = document.tree();
    tap(2);
    QTRY_COMPARE(document.undoStack().index(), steps - 1);
    tap(3);
    QTRY_COMPARE(document.undoStack().index(), steps);
    QTRY_VERIFY(document.edit() == nullptr);
    QVERIFY(document.tree() == tree);
    tap(4);
    QTRY_VERIFY(!workspace().topBar().isVisible());
    tap(4);
    QTRY_VERIFY(workspace().topBar().isVisible());
    QVERIFY(document.tree() == tree);
}

static const test::TestClass<ComfortsTest> comfortsTest;

#include "ComfortsTest.moc"

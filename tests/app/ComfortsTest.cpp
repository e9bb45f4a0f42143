// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HeldToolKey.h"
#include "panels/RingMenu.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QAction>
#include <QCoreApplication>
#include <QCursor>
#include <QPoint>
#include <QPointingDevice>
#include <QScreen>
#include <QTabletEvent>
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
    void ring_isUsedByClicks();
    void ring_isUsedWithTheKeyHeld();
    void ring_goesAwayWithoutAChoice();
    void ring_atAnEdge_waitsForAChoice();
    void ring_waitsForTheButton();
    void penBesideTheRing_closesIt();

private:
    RingMenu& ring() { return *m_window->findChild<RingMenu*>(); }
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

void ComfortsTest::ring_isUsedByClicks()
{
    makeTree();
    const QPoint place = at(0.6F, 1.0F);
    const auto open = [&] {
        QTest::mouseClick(handle(), Qt::RightButton, {}, place);
        QTRY_VERIFY(ring().isVisible());
        // Its middle is under the pointer.
        const QPoint middle = ring().mapToGlobal(ring().rect().center());
        QVERIFY((middle - handle()->mapToGlobal(place)).manhattanLength() <= 4);
    };
    const auto click = [&](ActionId id) {
        QTest::mouseClick(&ring(), Qt::LeftButton, {}, ring().placeOf(id).toPoint());
    };
    open();
    QTRY_VERIFY(ring().isVisible());
    click(ActionId::Prune);
    QTRY_VERIFY(hasTool(ActionId::Prune));
    QVERIFY(!ring().isVisible());

    const std::uint32_t whole = m_window->document().index().livingCount();
    open();
    click(ActionId::Undo);
    QTRY_VERIFY(m_window->document().index().livingCount() < whole);
    open();
    click(ActionId::Redo);
    QTRY_COMPARE(m_window->document().index().livingCount(), whole);

    // The brush is made larger as often as one likes.
    const auto radius = [&] { return m_window->viewSettings().values().brushRadius; };
    const double before = radius();
    open();
    click(ActionId::LargerBrush);
    const double once = radius();
    QVERIFY(once > before && ring().isVisible());
    click(ActionId::LargerBrush);
    QVERIFY(radius() > once);
    click(ActionId::SmallerBrush);
    QCOMPARE(radius(), once);
    QTest::keyClick(&ring(), Qt::Key_Escape);
    QVERIFY(!ring().isVisible());
    // The keys belong to the tree again.
    QTest::keyClick(handle(), Qt::Key_B);
    QTRY_VERIFY(hasTool(ActionId::Brush));
}

void ComfortsTest::ring_isUsedWithTheKeyHeld()
{
    QCursor::setPos(handle()->mapToGlobal(at(0.6F, 1.0F)));
    QTest::keyPress(handle(), Qt::Key_D);
    QTRY_VERIFY(ring().isVisible());
    const QPoint lasso = ring().placeOf(ActionId::Lasso).toPoint();
    QTest::mouseMove(&ring(), lasso);
    QTest::keyRelease(&ring(), Qt::Key_D);
    QTRY_VERIFY(hasTool(ActionId::Lasso));
    QVERIFY(!ring().isVisible());

    // A tap of the key leaves it open for clicks.
    QTest::keyClick(handle(), Qt::Key_D);
    QTRY_VERIFY(ring().isVisible());
    QTest::mouseClick(&ring(), Qt::LeftButton, {}, ring().placeOf(ActionId::Bend).toPoint());
    QTRY_VERIFY(hasTool(ActionId::Bend));
}

void ComfortsTest::ring_goesAwayWithoutAChoice()
{
    QTest::mouseClick(handle(), Qt::RightButton, {}, at(0.6F, 1.0F));
    QTRY_VERIFY(ring().isVisible());
    QTest::mouseClick(&ring(), Qt::LeftButton, {}, ring().rect().center());
    QVERIFY(!ring().isVisible());
    QVERIFY(hasTool(ActionId::Brush));
    // A turn of the view opens none.
    const float azimuth = viewport().mainCamera().azimuth();
    const QPoint from = at(0.6F, 1.0F);
    QTest::mousePress(handle(), Qt::RightButton, {}, from);
    QTest::mouseMove(handle(), from + QPoint(30, 0));
    QTest::mouseMove(handle(), from + QPoint(60, 0));
    QTest::mouseRelease(handle(), Qt::RightButton, {}, from + QPoint(60, 0));
    QVERIFY(viewport().mainCamera().azimuth() != azimuth);
    QVERIFY(!ring().isVisible());
}

void ComfortsTest::ring_atAnEdge_waitsForAChoice()
{
    makeTree();
    // At an edge of the screen the ring does not have the pointer in its middle.
    const QRect room = handle()->screen()->availableGeometry();
    const int steps = m_window->document().undoStack().index();
    for (const QPoint place :
         {QPoint(room.right() - 2, room.center().y()), QPoint(room.right() - 85, room.center().y()),
          QPoint(85, room.center().y()), QPoint(room.center().x(), 85),
          QPoint(room.right() - 40, room.bottom() - 40)}) {
        ring().openAt(place, Qt::Key_D);
        QTRY_VERIFY(ring().isVisible());
        QTest::keyRelease(&ring(), Qt::Key_D);
        QVERIFY2(ring().isVisible(), qPrintable(QStringLiteral("at %1, %2").arg(place.x()).arg(place.y())));
        QTest::keyClick(&ring(), Qt::Key_Escape);
        QVERIFY(!ring().isVisible());
    }
    QVERIFY(hasTool(ActionId::Brush));
    QCOMPARE(m_window->document().undoStack().index(), steps);
}

void ComfortsTest::ring_waitsForTheButton()
{
    // While a button is held, its release would go to the ring.
    const QPoint from = at(0.6F, 1.0F);
    const float azimuth = viewport().mainCamera().azimuth();
    QTest::mousePress(handle(), Qt::RightButton, {}, from);
    QTest::mouseMove(handle(), from + QPoint(10, 0));
    QTest::keyClick(handle(), Qt::Key_D);
    QVERIFY(!ring().isVisible());
    QTest::mouseMove(handle(), from + QPoint(20, 0));
    QTest::mouseRelease(handle(), Qt::RightButton, {}, from + QPoint(20, 0));
    const float turned = viewport().mainCamera().azimuth();
    QVERIFY(turned != azimuth);
    QTest::mouseMove(handle(), from + QPoint(90, 50));
    QCOMPARE(viewport().mainCamera().azimuth(), turned);
    // A shortcut closes the ring and is not lost; a modifier alone does not close it.
    ring().openAt(handle()->mapToGlobal(from));
    QTRY_VERIFY(ring().isVisible());
    QTest::keyPress(&ring(), Qt::Key_Shift);
    QVERIFY(ring().isVisible());
    QTest::keyClick(&ring(), Qt::Key_P);
    QVERIFY(!ring().isVisible());
    QTRY_VERIFY(hasTool(ActionId::Prune));
}

void ComfortsTest::penBesideTheRing_closesIt()
{
    makeTree();
    const int steps = m_window->document().undoStack().index();
    ring().openAt(handle()->mapToGlobal(at(0.6F, 1.0F)));
    QTRY_VERIFY(ring().isVisible());
    static const QPointingDevice pen(
        "test stylus", 90, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
    const QPointF place = viewport().mapFromGlobal(QPointF(handle()->mapToGlobal(at(0.0F, 1.5F))));
    const auto send = [&](QEvent::Type type, const QPointF& at, bool isDown) {
        QTabletEvent event(type, &pen, at, viewport().mapToGlobal(at), isDown ? 0.5 : 0.0, 0.0F, 0.0F, 0.0F,
                           0.0, 0.0F, Qt::NoModifier,
                           type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           isDown ? Qt::LeftButton : Qt::NoButton);
        QCoreApplication::sendEvent(&viewport(), &event);
    };
    send(QEvent::TabletPress, place, true);
    QVERIFY(!ring().isVisible());
    QVERIFY(!viewport().isGestureActive());
    send(QEvent::TabletMove, place - QPointF(0.0, 60.0), true);
    send(QEvent::TabletRelease, place - QPointF(0.0, 60.0), false);
    QCOMPARE(m_window->document().undoStack().index(), steps);
}

void ComfortsTest::shiftDrag_changesTheRadiusInPlace()
{
    const auto radius = [&] { return m_window->viewSettings().values().brushRadius; };
    const double before = radius();
    const double perMetre = static_cast<double>(
        viewport().mainCamera().pixelsPerMetre(viewport().mainCamera().depth(Vec3::Zero())));
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

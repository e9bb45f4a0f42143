// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/Edit.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QEvent>
#include <QFocusEvent>
#include <QInputDevice>
#include <QKeyCombination>
#include <QKeySequence>
#include <QMenu>
#include <QMessageBox>
#include <QPoint>
#include <QPointF>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>
#include <QTimer>
#include <QTouchEvent>
#include <QWidget>

#include <functional>

using namespace espalier;

/// A gesture that is interrupted before its pointer is lifted ends and is one undo step. Only Escape cancels
/// it.
class InterruptionsTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void interruption_endsTheGestureAsOneUndoStep_data();
    void interruption_endsTheGestureAsOneUndoStep();
    void escape_takesTheGestureBack_data();
    void escape_takesTheGestureBack();
    void save_keepsTheStrokeUnderTheHand();
    void close_asksAboutTheStrokeUnderTheHand();
    void undo_takesBackTheStrokeUnderTheHand_andRedoBringsItBack();
    void undo_ofAPressThatDidNothing_leavesTheStepBefore();
    void camera_staysInTheHand();
    void otherHand_mayUseAControl();
    void penOutOfReach_endsTheStroke();
    void touchThatTheSystemTakes_endsTheStroke();
    void sunUnderTheHand_staysWhereItIs();

private:
    /// Makes a straight stem with branches as the only undo step.
    void plant();
    /// Selects a tool and begins a gesture that changes something.
    void begin(ActionId tool);
    void release() { QTest::mouseRelease(handle(), Qt::LeftButton, {}, m_hand); }
    void moveTo(const QPoint& place);
    /// Answers the next modal dialog with its Cancel.
    void rejectDialog();

    QPoint m_hand; ///< Place of the pressed mouse
};

void InterruptionsTest::plant()
{
    TreeDocument& document = m_window->document();
    const std::vector<Vec3> stem{Vec3::Zero(), {0.0F, 1.2F, 0.0F}};
    test::brush(document, test::strokeAlong(stem, 0.0F, 0.6));
    QVERIFY(document.index().livingCount() > 8);
    document.undoStack().clear();
}

void InterruptionsTest::moveTo(const QPoint& place)
{
    m_hand = place;
    QTest::mouseMove(handle(), place);
    QTest::qWait(20);
}

void InterruptionsTest::begin(ActionId tool)
{
    action(tool)->trigger();
    const auto press = [this](const QPoint& place) {
        m_hand = place;
        QTest::mousePress(handle(), Qt::LeftButton, {}, place);
    };
    switch (tool) {
    case ActionId::Grow:
        press(at(0.8F, 0.6F));
        QTRY_VERIFY(m_window->document().tree().step() > 0 &&
                    m_window->growRunner().gesture()->stepCount() > 1);
        break;
    case ActionId::Bend:
    case ActionId::Width:
    case ActionId::Twist:
        press(at(0.0F, 0.7F));
        for (int i = 1; i <= 6; ++i)
            moveTo(at(0.0F, 0.7F) + QPoint(8 * i, 0));
        break;
    case ActionId::Prune:
        press(at(-0.4F, 0.6F));
        for (int i = 1; i <= 6; ++i)
            moveTo(at(-0.4F + 0.15F * static_cast<float>(i), 0.6F));
        break;
    case ActionId::Invigorate:
    case ActionId::Reduce:
        press(at(0.0F, 0.3F));
        QTRY_VERIFY(m_window->document().edit() != nullptr && m_window->document().edit()->deltaCount() > 0);
        break;
    case ActionId::Lasso:
        press(at(-0.6F, 0.8F));
        for (const QPoint& place : {at(0.0F, 0.3F), at(0.6F, 0.8F), at(0.0F, 1.4F)})
            moveTo(place);
        break;
    default:
        press(at(0.0F, 0.8F));
        for (int i = 1; i <= 12; ++i)
            moveTo(at(0.06F * static_cast<float>(i), 0.8F));
        break;
    }
    QVERIFY(viewport().isGestureActive());
}

void InterruptionsTest::rejectDialog()
{
    QTimer::singleShot(50, this, [this] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog)
            return rejectDialog();
        dialog->reject();
    });
}

void InterruptionsTest::interruption_endsTheGestureAsOneUndoStep_data()
{
    QTest::addColumn<ActionId>("tool");
    QTest::addColumn<QString>("what");
    using enum ActionId;
    const auto add = [](ActionId tool, const char* name, const char* what) {
        QTest::addRow("%s, %s", name, what) << tool << QString::fromLatin1(what);
    };
    const std::pair<ActionId, const char*> tools[] = {
        {Brush, "brush"},           {Bend, "bend"},     {Width, "width"},
        {Prune, "prune"},           {Lasso, "lasso"},   {Grow, "grow"},
        {Invigorate, "invigorate"}, {Reduce, "reduce"}, {Twist, "twist"}};
    for (const auto& [tool, name] : tools) {
        add(tool, name, "P");
        add(tool, name, "W");
        add(tool, name, "window");
    }
    for (const char* what : {"B", "O", "Shift+G", "Shift+B", "U", "F6", "Ctrl+L", "Ctrl+,", "open dialog",
                             "message", "menu", "hidden"})
        add(Brush, "brush", what);
}

void InterruptionsTest::interruption_endsTheGestureAsOneUndoStep()
{
    QFETCH(ActionId, tool);
    QFETCH(QString, what);
    plant();
    TreeDocument& document = m_window->document();
    const test::DocumentState before(document);
    begin(tool);
    QMessageBox message(m_window.get());
    QWidget other;
    QMenu menu(m_window.get());
    if (what == QStringLiteral("window")) {
        other.show();
        other.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&other));
    } else if (what == QStringLiteral("open dialog")) {
        rejectDialog();
        QTest::keyClick(handle(), Qt::Key_O, Qt::ControlModifier);
    } else if (what == QStringLiteral("message")) {
        message.open();
        QVERIFY(QTest::qWaitForWindowExposed(&message));
    } else if (what == QStringLiteral("menu")) {
        menu.addAction(QStringLiteral("nothing"));
        menu.popup(m_window->mapToGlobal(QPoint(10, 10)));
        QTRY_VERIFY(menu.isVisible());
    } else if (what == QStringLiteral("hidden")) {
        viewport().hide();
    } else {
        const QKeyCombination keys = QKeySequence(what)[0];
        QTest::keyClick(handle(), keys.key(), keys.keyboardModifiers());
    }
    // A lasso begins to fill when its stroke ends, unless its tool is deselected.
    QTRY_VERIFY(!viewport().isGestureActive());
    if (tool == ActionId::Lasso && m_window->isHandBusy())
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isHandBusy(), 20000);
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(test::differenceFrom(before, document) != QString());
    message.close();
    menu.close();
    other.close();
    for (QDialog* sheet : m_window->findChildren<QDialog*>())
        sheet->close();
    action(ActionId::Library)->setChecked(false);
    viewport().show();

    // The release of the pointer adds nothing.
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    moveTo(m_hand + QPoint(30, 10));
    release();
    QCoreApplication::processEvents();
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(!m_window->isBusy());
    document.undoStack().undo();
    QCOMPARE(test::differenceFrom(before, document), QString());
}

void InterruptionsTest::escape_takesTheGestureBack_data()
{
    QTest::addColumn<ActionId>("tool");
    QTest::newRow("brush") << ActionId::Brush;
    QTest::newRow("bend") << ActionId::Bend;
    QTest::newRow("width") << ActionId::Width;
    QTest::newRow("prune") << ActionId::Prune;
    QTest::newRow("twist") << ActionId::Twist;
    QTest::newRow("lasso") << ActionId::Lasso;
    QTest::newRow("grow") << ActionId::Grow;
    QTest::newRow("invigorate") << ActionId::Invigorate;
    QTest::newRow("reduce") << ActionId::Reduce;
}

void InterruptionsTest::escape_takesTheGestureBack()
{
    QFETCH(ActionId, tool);
    plant();
    const test::DocumentState before(m_window->document());
    begin(tool);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(!viewport().isGestureActive());
    release();
    QCoreApplication::processEvents();
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QCOMPARE(test::differenceFrom(before, m_window->document()), QString());
}

void InterruptionsTest::save_keepsTheStrokeUnderTheHand()
{
    const QString name = m_folder->filePath(QStringLiteral("tree.espalier"));
    save(name);
    begin(ActionId::Brush);
    QSignalSpy saved(&m_window->files().file(), &DocumentFile::saved);
    QTest::keyClick(handle(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!viewport().isGestureActive());
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, 30000);
    release();
    QCOMPARE(m_window->document().undoStack().count(), 1);
    QVERIFY(!m_window->isWindowModified());
    const Result<Project> project = loadProject(name);
    QVERIFY(project);
    QCOMPARE(TreeIndex(project->tree).livingCount(), m_window->document().index().livingCount());
}

void InterruptionsTest::close_asksAboutTheStrokeUnderTheHand()
{
    begin(ActionId::Brush);
    bool wasAsked = false;
    QTimer::singleShot(100, this, [&wasAsked] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        wasAsked = box != nullptr;
        if (box)
            box->button(QMessageBox::Cancel)->click();
    });
    QVERIFY(!m_window->close());
    QVERIFY(wasAsked);
    QVERIFY(m_window->isVisible());
    QCOMPARE(m_window->document().undoStack().count(), 1);
    QVERIFY(m_window->document().index().livingCount() > 1);
    release();
}

void InterruptionsTest::undo_takesBackTheStrokeUnderTheHand_andRedoBringsItBack()
{
    plant();
    TreeDocument& document = m_window->document();
    const test::DocumentState before(document);
    begin(ActionId::Brush);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(test::differenceFrom(before, document), QString());
    release();
    QCoreApplication::processEvents();
    QCOMPARE(document.undoStack().count(), 1);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(test::differenceFrom(before, document) != QString());
}

void InterruptionsTest::undo_ofAPressThatDidNothing_leavesTheStepBefore()
{
    brush();
    TreeDocument& document = m_window->document();
    const std::uint32_t living = document.index().livingCount();
    action(ActionId::Prune)->trigger();
    m_hand = at(1.5F, 0.2F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, m_hand);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.index().livingCount(), living);
    release();
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.index().livingCount(), 1U);
}

void InterruptionsTest::camera_staysInTheHand()
{
    const float azimuth = viewport().mainCamera().azimuth();
    QTest::mousePress(handle(), Qt::RightButton, {}, at(0.5F, 0.5F));
    QTest::keyClick(handle(), Qt::Key_P);
    QTest::mouseMove(handle(), at(0.5F, 0.5F) + QPoint(40, 0));
    QTest::mouseRelease(handle(), Qt::RightButton, {}, at(0.5F, 0.5F) + QPoint(40, 0));
    QVERIFY(viewport().mainCamera().azimuth() != azimuth);
    QVERIFY(action(ActionId::Prune)->isChecked());
}

void InterruptionsTest::otherHand_mayUseAControl()
{
    begin(ActionId::Brush);
    // A press of another pointer brings the focus along.
    QFocusEvent out(QEvent::FocusOut, Qt::MouseFocusReason);
    QCoreApplication::sendEvent(&viewport(), &out);
    QVERIFY(viewport().isGestureActive());
    release();
    QCOMPARE(m_window->document().undoStack().count(), 1);
}

void InterruptionsTest::penOutOfReach_endsTheStroke()
{
    static const QPointingDevice pen(QStringLiteral("pen"), 17, QInputDevice::DeviceType::Stylus,
                                     QPointingDevice::PointerType::Pen, QInputDevice::Capability::Pressure, 1,
                                     2);
    const auto send = [this](QObject* to, QEvent::Type type, const QPointF& place, Qt::MouseButtons buttons) {
        QTabletEvent event(type, &pen, place, viewport().mapToGlobal(place), 0.8, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                           {}, type == QEvent::TabletPress ? Qt::LeftButton : Qt::NoButton, buttons);
        QCoreApplication::sendEvent(to, &event);
    };
    const QPointF from = viewport().mapFrom(m_window.get(), at(0.0F, 0.0F));
    send(&viewport(), QEvent::TabletPress, from, Qt::LeftButton);
    for (int i = 1; i <= 15; ++i) {
        send(&viewport(), QEvent::TabletMove, from - QPointF(0.0, 8.0 * i), Qt::LeftButton);
        QTest::qWait(20);
    }
    QVERIFY(viewport().isGestureActive());
    send(qApp, QEvent::TabletLeaveProximity, from, Qt::NoButton);
    QVERIFY(!viewport().isGestureActive());
    QCOMPARE(m_window->document().undoStack().count(), 1);
    QVERIFY(m_window->document().index().livingCount() > 5);
    // A pen that comes back draws again.
    send(qApp, QEvent::TabletEnterProximity, from, Qt::NoButton);
    send(&viewport(), QEvent::TabletPress, from, Qt::LeftButton);
    QVERIFY(viewport().isGestureActive());
    send(&viewport(), QEvent::TabletRelease, from, Qt::NoButton);
    // While a pen is near, fingers are taken for the palm.
    send(qApp, QEvent::TabletLeaveProximity, from, Qt::NoButton);
    QTest::qWait(1200);
}

void InterruptionsTest::touchThatTheSystemTakes_endsTheStroke()
{
    const QPoint from = at(0.0F, 0.0F);
    QTest::touchEvent(handle(), m_screen).press(1, from, handle());
    for (int i = 1; i <= 15; ++i) {
        QTest::touchEvent(handle(), m_screen).move(1, from - QPoint(0, 8 * i), handle());
        QTest::qWait(20);
    }
    QVERIFY(viewport().isGestureActive());
    // In Qt's form: without points.
    QTouchEvent event(QEvent::TouchCancel, m_screen);
    QCoreApplication::sendEvent(&viewport(), &event);
    QVERIFY(!viewport().isGestureActive());
    QCOMPARE(m_window->document().undoStack().count(), 1);
    const std::uint32_t grown = m_window->document().index().livingCount();
    QVERIFY(grown > 5);
    QTest::qWait(200);
    QCOMPARE(m_window->document().index().livingCount(), grown);
    QTest::touchEvent(handle(), m_screen).release(1, from, handle());
}

void InterruptionsTest::sunUnderTheHand_staysWhereItIs()
{
    m_window->viewSettings().set(&ViewValues::sunShown, true);
    const double azimuth = m_window->viewSettings().values().sunAzimuth;
    m_hand = viewport().mapTo(m_window.get(), viewport().sunPlace().toPoint());
    QTest::mousePress(handle(), Qt::LeftButton, {}, m_hand);
    QVERIFY(viewport().isGestureActive());
    for (int i = 1; i <= 5; ++i)
        moveTo(m_hand + QPoint(-15, 0));
    QTest::keyClick(handle(), Qt::Key_P);
    QVERIFY(!viewport().isGestureActive());
    QVERIFY(m_window->viewSettings().values().sunAzimuth != azimuth);
    release();
}

static const test::TestClass<InterruptionsTest> interruptionsTest;

#include "InterruptionsTest.moc"

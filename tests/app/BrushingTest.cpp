// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SketchStroke.h"
#include "panels/Bar.h"
#include "panels/RadiusSlider.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QInputDevice>
#include <QLabel>
#include <QMouseEvent>
#include <QPoint>
#include <QPointF>
#include <QPointingDevice>
#include <QSlider>
#include <QTabletEvent>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

using namespace espalier;

/// The user at the real window with the tools Brush, Bend and Width.
class BrushingTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void history_saysHowMuchAStrokeGrew();
    void mouse_brushesATreeAsOneUndoStep();
    void finger_brushesATree();
    void pen_brushesByItsPressure();
    void escape_takesTheStrokeBack();
    void undoDuringAStroke_takesBackThatAlone();
    void keys_changeTheBrushAndWhatIsShown();
    void bendAndWidth_areAtHand();
    void line_arrivesAtAnySpeed_data();
    void line_arrivesAtAnySpeed();
    void flick_isUndoneAndRedone();
    void strokeThatGrowsNothing_saysWhy();

private:
    void drawTrunk();
    void drawLimb(const QPointF& from, const QPointF& to, double speed, double rate, bool isBusy);
    QPointF limbBegin()
    {
        return viewport().mainCamera().project(Vec3(0.0F, 1.2F, 0.0F)).value_or(QPointF());
    }
};

/// A document with nothing but a trunk of two metres.
void BrushingTest::drawTrunk()
{
    m_window->document().reset(4, TreeParameters());
    const LassoStroke trunk{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {Vec2(0.0F, 0.0F), Vec2(0.0F, 2.0F)}};
    QVERIFY(sketchBranch(m_window->document(), {.stroke = trunk, .base = {}}));
    m_window->viewSettings().set(&ViewValues::brushRadius, 0.057);
    QTRY_VERIFY(viewport().isAtRest()); // The camera has come to the new tree.
}

/// Sends the events of a mouse, in px/s and events a second, with the timestamps of its clock. A busy program
/// gets them late and in heaps.
void BrushingTest::drawLimb(const QPointF& from, const QPointF& to, double speed, double rate, bool isBusy)
{
    const double seconds = std::hypot(to.x() - from.x(), to.y() - from.y()) / speed;
    const int last = std::max(2, static_cast<int>(std::lround(seconds * rate)));
    const auto stampOf = [&](int i) { return std::llround(1000.0 * seconds * i / last); };
    const auto send = [&](int i) {
        const auto type = i == 0      ? QEvent::MouseButtonPress
                          : i == last ? QEvent::MouseButtonRelease
                                      : QEvent::MouseMove;
        const QPointF place = from + static_cast<double>(i) / last * (to - from);
        QMouseEvent event(type, place, viewport().mapToGlobal(place),
                          type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
        event.setTimestamp(50'000 + static_cast<quint64>(stampOf(i)));
        QCoreApplication::sendEvent(&viewport(), &event);
    };
    QElapsedTimer clock;
    clock.start();
    for (int next = 0; next <= last;) {
        while (next <= last && stampOf(next) <= clock.elapsed())
            send(next++);
        QTest::qSleep(isBusy ? 120 : 1);
        QCoreApplication::processEvents();
    }
}

void BrushingTest::history_saysHowMuchAStrokeGrew()
{
    brush();
    brush(1.0F, 1.7F, 0.4F);
    const TreeDocument& document = m_window->document();
    int branches = 0;
    for (InternodeId id = 1; id < document.tree().size(); ++id)
        branches += document.tree().isAlive(id) && document.index().axis(id) == id ? 1 : 0;
    int told = 0;
    for (int i = 0; i < document.undoStack().count(); ++i) {
        const QString text = document.undoStack().text(i);
        QVERIFY2(text.startsWith(QStringLiteral("Brush Stroke")), qPrintable(text));
        const QString number = text.section(QLatin1Char(' '), 2, 2);
        told += number.isEmpty() ? 0 : number.toInt();
    }
    QVERIFY2(told > 1 && told <= branches && told >= branches - document.undoStack().count(),
             qPrintable(QStringLiteral("%1 of %2").arg(told).arg(branches)));
}

void BrushingTest::mouse_brushesATreeAsOneUndoStep()
{
    QVERIFY(!action(ActionId::Undo)->isEnabled());
    brush();
    const TreeDocument& document = m_window->document();
    QVERIFY(document.index().livingCount() > 30);
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(m_window->isWindowModified());
    QVERIFY(m_window->windowTitle().contains(QStringLiteral("[*] – Espalier")));
    QVERIFY(!viewport().isGestureActive());

    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(document.index().livingCount(), 1U);
    QVERIFY(!m_window->isWindowModified());
}

void BrushingTest::line_arrivesAtAnySpeed_data()
{
    QTest::addColumn<double>("speed"); // px/s
    QTest::addColumn<double>("rate");  // Events a second
    QTest::newRow("slow") << 200.0 << 60.0;
    QTest::newRow("quick, few events") << 700.0 << 15.0;
    QTest::newRow("quick, many events") << 700.0 << 250.0;
    QTest::newRow("a flick") << 5000.0 << 60.0;
    QTest::newRow("a flick, many events") << 5000.0 << 250.0;
}

void BrushingTest::line_arrivesAtAnySpeed()
{
    QFETCH(const double, speed);
    QFETCH(const double, rate);
    const TreeDocument& document = m_window->document();
    std::optional<Tree> first;
    for (const bool isBusy : {false, true, true}) {
        drawTrunk();
        const QPointF from = limbBegin();
        const QPointF to = from + QPointF(220.0, -90.0);
        drawLimb(from, to, speed, rate, isBusy);
        QCOMPARE(document.undoStack().count(), 2);
        const Vec3 end = viewport().mainCamera().onPlane(to, Vec3(0.0F, 1.2F, 0.0F));
        float nearest = std::numeric_limits<float>::infinity();
        for (InternodeId id = 0; id < document.tree().size(); ++id)
            nearest = std::min(nearest, (document.index().nodePosition(id) - end).norm());
        QVERIFY2(nearest < 0.17F, qPrintable(QString::number(static_cast<double>(nearest))));
        if (!first)
            first = document.tree();
        QVERIFY(document.tree() == *first);
    }
}

void BrushingTest::flick_isUndoneAndRedone()
{
    drawTrunk();
    const TreeDocument& document = m_window->document();
    const std::uint32_t trunk = document.tree().size();
    drawLimb(limbBegin(), limbBegin() + QPointF(220.0, -90.0), 5000.0, 60.0, true);
    const Tree whole = document.tree();
    QVERIFY(whole.size() > trunk);
    action(ActionId::Undo)->trigger();
    QCOMPARE(document.index().livingCount(), trunk);
    action(ActionId::Redo)->trigger();
    QVERIFY(document.tree() == whole);
}

void BrushingTest::strokeThatGrowsNothing_saysWhy()
{
    makeTree();
    QTRY_VERIFY(viewport().isAtRest());
    const auto reasons = [this] {
        Overlay overlay;
        viewport().tool().paint(overlay);
        return overlay.labels().size();
    };
    m_window->viewSettings().set(&ViewValues::brushRadius, 0.1);
    const std::uint32_t before = m_window->document().tree().size();
    const QPoint air = at(1.9F, 0.6F);
    QTest::mousePress(handle(), Qt::LeftButton, Qt::NoModifier, air);
    QVERIFY(reasons() == 0);
    QTRY_VERIFY(reasons() == 1);
    QCOMPARE(m_window->document().tree().size(), before);
    // A stroke from there is reached, and says so by growing.
    for (int i = 1; i <= 10; ++i)
        QTest::mouseMove(handle(), air - QPoint(0, 4 * i), 20);
    QTRY_VERIFY(m_window->document().tree().size() > before);
    QVERIFY(reasons() == 0);
    QTest::mouseRelease(handle(), Qt::LeftButton, Qt::NoModifier, air - QPoint(0, 40));
}

void BrushingTest::finger_brushesATree()
{
    const QPoint from = at(0.0F, 0.0F);
    const QPoint to = at(0.0F, 1.6F);
    QTest::touchEvent(handle(), m_screen).press(1, from, handle());
    for (int i = 1; i <= 25; ++i) {
        QTest::touchEvent(handle(), m_screen).move(1, from + (to - from) * i / 25, handle());
        QTest::qWait(20);
    }
    QVERIFY(viewport().isGestureActive());
    QTest::touchEvent(handle(), m_screen).release(1, to, handle());
    QTRY_COMPARE(m_window->document().undoStack().count(), 1);
    QVERIFY(m_window->document().index().livingCount() > 30);
}

void BrushingTest::pen_brushesByItsPressure()
{
    const auto penStroke = [this](double pressure) {
        static const QPointingDevice pen(QStringLiteral("pen"), 7, QInputDevice::DeviceType::Stylus,
                                         QPointingDevice::PointerType::Pen,
                                         QInputDevice::Capability::Pressure, 1, 2);
        const QPoint from = at(0.0F, 0.0F);
        const QPoint to = at(0.0F, 1.6F);
        for (int i = 0; i <= 26; ++i) {
            const auto type = i == 0    ? QEvent::TabletPress
                              : i == 26 ? QEvent::TabletRelease
                                        : QEvent::TabletMove;
            const QPointF place =
                viewport().mapFrom(m_window.get(), from + (to - from) * std::min(i, 25) / 25);
            QTabletEvent event(type, &pen, place, viewport().mapToGlobal(place), i == 26 ? 0.0 : pressure,
                               0.0F, 0.0F, 0.0F, 0.0, 0.0F, {}, Qt::LeftButton,
                               i == 26 ? Qt::NoButton : Qt::LeftButton);
            QCoreApplication::sendEvent(&viewport(), &event);
            QTest::qWait(20);
        }
        QCoreApplication::processEvents();
        const TreeDocument& document = m_window->document();
        const std::uint32_t grown = document.index().livingCount();
        Box3 bounds;
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            if (document.tree().isAlive(id))
                bounds.extend(document.index().nodePosition(id));
        }
        m_window->document().undoStack().undo();
        return std::pair(grown, bounds.sizes().x());
    };
    const auto [many, wide] = penStroke(1.0);
    const auto [few, narrow] = penStroke(0.25);
    QVERIFY(many > 30);
    QVERIFY(few > 3);
    QVERIFY2(narrow < 0.8F * wide, qPrintable(QStringLiteral("%1 m, %2 m").arg(narrow).arg(wide)));
}

void BrushingTest::escape_takesTheStrokeBack()
{
    const QPoint from = at(0.0F, 0.0F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 20; ++i) {
        QTest::mouseMove(handle(), from - QPoint(0, 6 * i));
        QTest::qWait(20);
    }
    QVERIFY(m_window->document().index().livingCount() > 10);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_COMPARE(m_window->document().index().livingCount(), 1U);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from);
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QVERIFY(!m_window->isWindowModified());
}

void BrushingTest::undoDuringAStroke_takesBackThatAlone()
{
    brush();
    const std::uint32_t before = m_window->document().index().livingCount();
    const QPoint from = at(0.3F, 1.0F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    QTest::qWait(150);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTest::qWait(50);
    QCOMPARE(m_window->document().index().livingCount(), before);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from);
    QCoreApplication::processEvents();
    while (m_window->document().undoStack().canUndo())
        m_window->document().undoStack().undo();
    QCOMPARE(m_window->document().index().livingCount(), 1U);
}

void BrushingTest::keys_changeTheBrushAndWhatIsShown()
{
    const ViewSettings& settings = m_window->viewSettings();
    QTest::keyClick(handle(), Qt::Key_BracketLeft);
    QTRY_VERIFY(settings.values().brushRadius < 0.5);
    QTest::keyClick(handle(), Qt::Key_BracketRight);
    QTest::keyClick(handle(), Qt::Key_BracketRight);
    QTRY_VERIFY(settings.values().brushRadius > 0.5);
    auto* slider = m_window->findChild<RadiusSlider*>();
    QCOMPARE(slider->radius(), settings.values().brushRadius);
    // From a twig to a crown it takes few presses.
    m_window->viewSettings().set(&ViewValues::brushRadius, 0.05);
    for (int i = 0; i < 9; ++i)
        QTest::keyClick(handle(), Qt::Key_BracketRight);
    QVERIFY(settings.values().brushRadius > 0.52);

    const bool markers = settings.values().markersShown;
    QTest::keyClick(handle(), Qt::Key_M);
    QTRY_COMPARE(settings.values().markersShown, !markers);
    QCOMPARE(action(ActionId::Markers)->isChecked(), !markers);
    const bool leaves = settings.values().leavesShown;
    QTest::keyClick(handle(), Qt::Key_L);
    QTRY_COMPARE(settings.values().leavesShown, !leaves);
}

void BrushingTest::bendAndWidth_areAtHand()
{
    brush();
    const TreeDocument& document = m_window->document();
    const Tree grown = document.tree();
    InternodeId top = 0;
    for (InternodeId id = 1; id < grown.size(); ++id) {
        if (grown.isAlive(id) &&
            document.index().nodePosition(id).y() > document.index().nodePosition(top).y())
            top = id;
    }
    const auto seen = [&](InternodeId id) {
        return viewport().mapTo(
            m_window.get(), viewport().mainCamera().project(document.index().nodePosition(id))->toPoint());
    };
    QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ShiftModifier);
    QVERIFY(action(ActionId::Bend)->isChecked());
    auto* stretching = m_window->findChild<QSlider*>(QStringLiteral("stretchingWeight"));
    QVERIFY(stretching && stretching->isVisible());
    stretching->setValue(stretching->maximum());
    QCOMPARE(m_window->viewSettings().values().stretchingWeight, kMostBendWeight);
    const auto* shown = m_window->findChild<QLabel*>(QStringLiteral("stretchingWeightValue"));
    QVERIFY(shown->isVisible() && shown->text().contains(QString::number(static_cast<int>(kMostBendWeight))));

    // A pin, which Escape removes before anything else.
    const InternodeId low = document.index().mainChild(0);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, seen(low));
    action(ActionId::Architecture)->trigger();
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    QVERIFY(action(ActionId::Architecture)->isChecked());
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    QVERIFY(!action(ActionId::Architecture)->isChecked());

    const QPoint from = seen(top);
    std::vector<Vec3> before;
    for (InternodeId id = 0; id < grown.size(); ++id)
        before.push_back(document.index().nodePosition(id));
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) {
        QTest::mouseMove(handle(), from + QPoint(8, 3) * i);
        QTest::qWait(16);
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from + QPoint(80, 30));
    // The branch under the pointer: that of the topmost node, or one in front of it.
    float moved = 0.0F;
    for (InternodeId id = 0; id < grown.size(); ++id)
        moved = std::max(moved, (document.index().nodePosition(id) - before[id]).norm());
    QVERIFY2(moved > 0.2F, qPrintable(QStringLiteral("%1, %2").arg(moved).arg(top)));
    QCOMPARE(document.undoStack().count(), 2);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.tree() == grown);

    QTest::keyClick(m_window.get(), Qt::Key_W);
    QVERIFY(action(ActionId::Width)->isChecked());
    QVERIFY(!stretching->isVisible());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, seen(low));
    QCOMPARE(document.tree().widthConstraints().size(), 1U);
    QTest::keyClick(handle(), Qt::Key_Delete);
    QVERIFY(document.tree().widthConstraints().empty());
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.tree().widthConstraints().size(), 1U);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.tree() == grown);
}

static const test::TestClass<BrushingTest> brushingTest;

#include "BrushingTest.moc"

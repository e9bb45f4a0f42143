// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/TestClasses.h"
#include "tests/support/ViewportFixture.h"
#include "views/tools/BrushTool.h"
#include "views/tools/PruneTool.h"
#include "views/tools/ToolColours.h"

#include <QSignalSpy>
#include <QWheelEvent>

#include <cmath>
#include <numbers>

using namespace espalier;
using namespace espalier::test;

namespace {

/// Counts the samples that it gets.
class CountingTool : public Tool {
public:
    CountingTool(ToolContext& context, bool isFreehand) : Tool(context), m_isFreehand(isFreehand) {}

    void begin(const PointerSample&) override { m_isActive = true; }
    void move(const PointerSample& sample) override { moves.push_back(sample.position); }
    void end(const PointerSample&) override { m_isActive = false; }
    void finish() override { m_isActive = false; }
    void cancel() override { m_isActive = false; }
    bool isFreehand() const override { return m_isFreehand; }
    bool isActive() const override { return m_isActive; }
    QString tip() const override { return {}; }

    std::vector<QPointF> moves;

private:
    bool m_isFreehand;
    bool m_isActive = false;
};

} // namespace

class ViewportTest : public ViewportFixture {
    Q_OBJECT

private Q_SLOTS:
    void seedling_isShownBySettingOut();
    void mouseStroke_growsTheTreeAndIsOneUndoStep();
    void restingBrush_goesOnGrowing();
    void escape_takesTheStrokeBack();
    void secondFinger_takesTheStrokeBack();
    void fingerStroke_growsTheTree();
    void penStroke_scalesTheRadiusByPressure();
    void strokeFromANode_drawsInItsDepth();
    void strokeFromElsewhere_drawsInTheDepthOfTheBase();
    void radiusZero_drawsAnAxis();
    void controlWheel_changesTheRadiusDuringAStroke();
    void keysDuringAStroke_windTheTrunk();
    void orbitAndZoom_moveTheCameraAndLeaveTheTreeAlone();
    void frameAll_fliesToTheWholeTree();
    void namedViews_turnAndKeepTargetAndDistance();
    void frameAllDuringATurn_comesToBothEnds();
    void turnDuringAFlight_isKept();
    void newTool_finishesTheGestureOfTheOld();
    void picture_changesWithTheTreeAndComesToRest();
    void brushRadius_doesNotRedrawTheTree();
    void window_canBeChanged();
    void samplesThatWaited_areAllDrawnAndOtherwiseTheNewestWillDo();
    void drawnLine_isInTheNextPicture();
    void secondView_givesDepthToWhatIsDrawnInIt();
    void secondView_isPickedIn();
    void secondView_zoomsAndTurnsWithTheLargeOne();
    void secondView_needsRoom();
    void hoverInASecondViewThatGoesAway_isOver();
    void sun_isDraggedAndNothingIsUndone();
    void sun_goesBehindTheTreeBeyondTheRim();
    void escape_putsTheSunBack();
    void pinnedSun_staysOnTheScreen();
    void heldSun_staysUnderThePointerWhileTheTreeTurns();

private:
    bool isSunAt(const QPointF& place) const
    {
        const QPointF away = m_view->sunPlace() - place;
        return std::hypot(away.x(), away.y()) < 2.0;
    }
    void moveHeld(const QPointF& place)
    {
        QMouseEvent event(QEvent::MouseMove, place, m_view->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(m_view.get(), &event);
    }
    void pressSun() { QTest::mousePress(m_view.get(), Qt::LeftButton, {}, m_view->sunPlace().toPoint()); }
};

void ViewportTest::seedling_isShownBySettingOut()
{
    Camera expected;
    expected.setViewSize(m_view->size());
    QCOMPARE(m_view->mainCamera(), expected);
}

void ViewportTest::mouseStroke_growsTheTreeAndIsOneUndoStep()
{
    const Tree before = m_document->tree();
    QSignalSpy active(m_view.get(), &Viewport::gestureActiveChanged);
    stroke(Vec3::Zero(), {0.0F, 2.0F, 0.0F}, 700);
    QVERIFY(alive() > 3);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(active.count(), 2);
    QVERIFY(!m_view->isGestureActive());
    m_document->undoStack().undo();
    QCOMPARE(alive(), 1U);
    QVERIFY(m_document->tree().step() == before.step());
    m_document->undoStack().redo();
    QVERIFY(alive() > 3);
}

void ViewportTest::restingBrush_goesOnGrowing()
{
    press({0.0F, 0.8F, 0.0F});
    QTRY_VERIFY_WITH_TIMEOUT(alive() > 2, 4000);
    release({0.0F, 0.8F, 0.0F});
    const std::uint32_t grown = alive();
    QTest::qWait(150);
    QCOMPARE(alive(), grown);
}

void ViewportTest::escape_takesTheStrokeBack()
{
    press(Vec3::Zero());
    drag(Vec3::Zero(), {0.0F, 1.5F, 0.0F}, 500);
    QVERIFY(alive() > 1);
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    QVERIFY(!m_view->isGestureActive());
    QCOMPARE(alive(), 1U);
    QCOMPARE(m_document->undoStack().count(), 0);
    // The pointer that is still held draws nothing more.
    drag({0.0F, 1.5F, 0.0F}, {0.0F, 2.5F, 0.0F}, 200);
    release({0.0F, 2.5F, 0.0F});
    QCOMPARE(alive(), 1U);
}

void ViewportTest::secondFinger_takesTheStrokeBack()
{
    const QPoint base = at(Vec3::Zero());
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, base);
    for (int i = 1; i <= 20; ++i) {
        QTest::touchEvent(m_view.get(), m_touch.get()).move(0, base - QPoint(0, 5 * i));
        QTest::qWait(20);
    }
    QVERIFY(alive() > 1);
    QTest::touchEvent(m_view.get(), m_touch.get()).stationary(0).press(1, base + QPoint(100, 0));
    QVERIFY(!m_view->isGestureActive());
    QCOMPARE(alive(), 1U);
    const Vec3 target = m_view->mainCamera().target();
    QTest::touchEvent(m_view.get(), m_touch.get())
        .move(0, base - QPoint(-30, 100))
        .move(1, base + QPoint(130, 0));
    QVERIFY((m_view->mainCamera().target() - target).norm() > 0.01F);
    QTest::touchEvent(m_view.get(), m_touch.get())
        .release(0, base - QPoint(-30, 100))
        .release(1, base + QPoint(130, 0));
    QCOMPARE(m_document->undoStack().count(), 0);
}

void ViewportTest::fingerStroke_growsTheTree()
{
    const QPoint base = at(Vec3::Zero());
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, base);
    for (int i = 1; i <= 25; ++i) {
        QTest::touchEvent(m_view.get(), m_touch.get()).move(0, base - QPoint(0, 6 * i));
        QTest::qWait(20);
    }
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, base - QPoint(0, 150));
    QVERIFY(alive() > 3);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void ViewportTest::penStroke_scalesTheRadiusByPressure()
{
    const QPointF base = at(Vec3::Zero());
    sendPen(QEvent::TabletPress, base, 0.5);
    for (int i = 1; i <= 25; ++i) {
        sendPen(QEvent::TabletMove, base - QPointF(0, 6 * i), 0.5);
        QTest::qWait(20);
    }
    Overlay overlay;
    m_view->tool().paint(overlay);
    QCOMPARE(overlay.spheres().size(), std::size_t{1});
    const double expected = m_settings->values().brushRadius * BrushTool::radiusShare(0.5);
    QVERIFY(std::abs(static_cast<double>(overlay.spheres().front().radius) - expected) < 1e-6);
    QVERIFY(expected < m_settings->values().brushRadius);
    sendPen(QEvent::TabletRelease, base - QPointF(0, 150), 0.0);
    QVERIFY(alive() > 2);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(BrushTool::radiusShare(1.0), 1.0);
    QVERIFY(BrushTool::radiusShare(0.2) < BrushTool::radiusShare(0.6));
}

void ViewportTest::strokeFromANode_drawsInItsDepth()
{
    // From the side, draw away from the front; then from the front, begin at the tip of that.
    m_settings->set(&ViewValues::brushRadius, 0.0);
    Camera side = m_view->mainCamera().turnedTo(NamedView::Side);
    m_view->setCamera(side);
    stroke(Vec3::Zero(), {0.0F, 1.0F, 0.9F}, 700);
    m_view->setCamera(side.turnedTo(NamedView::Front));
    Vec3 tip = Vec3::Zero();
    for (InternodeId id = 0; id < m_document->tree().size(); ++id) {
        if (m_document->index().nodePosition(id).y() > tip.y())
            tip = m_document->index().nodePosition(id);
    }
    QVERIFY(tip.z() > 0.3F);
    press(tip);
    Overlay overlay;
    m_view->tool().paint(overlay);
    // Within an internode: seen along the axis, all its nodes are at one place.
    QVERIFY(std::abs(overlay.grids().front().centre.z() - tip.z()) < 0.25F);
    release(tip);
}

void ViewportTest::strokeFromElsewhere_drawsInTheDepthOfTheBase()
{
    press({1.0F, 2.0F, 0.0F});
    Overlay overlay;
    m_view->tool().paint(overlay);
    QVERIFY((overlay.spheres().front().centre - Vec3(1.0F, 2.0F, 0.0F)).norm() < 0.02F);
    release({1.0F, 2.0F, 0.0F});
}

void ViewportTest::radiusZero_drawsAnAxis()
{
    m_settings->set(&ViewValues::brushRadius, 0.0);
    stroke(Vec3::Zero(), {0.0F, 2.0F, 0.0F}, 800);
    QVERIFY(alive() > 3);
    for (InternodeId id = 1; id < m_document->tree().size(); ++id)
        QVERIFY(m_document->tree().continuesAxis(id));
}

void ViewportTest::controlWheel_changesTheRadiusDuringAStroke()
{
    press({0.0F, 1.0F, 0.0F});
    const double before = m_settings->values().brushRadius;
    const QPointF place(320, 240);
    const Camera camera = m_view->mainCamera();
    QWheelEvent event(place, m_view->mapToGlobal(place), {}, {0, 240}, Qt::LeftButton, Qt::ControlModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(m_view.get(), &event);
    QVERIFY(std::abs(m_settings->values().brushRadius - before * 1.21) < 1e-9);
    QCOMPARE(m_view->mainCamera(), camera);
    Overlay overlay;
    m_view->tool().paint(overlay);
    QVERIFY(std::abs(static_cast<double>(overlay.spheres().front().radius) - before * 1.21) < 1e-6);
    release({0.0F, 1.0F, 0.0F});
}

void ViewportTest::keysDuringAStroke_windTheTrunk()
{
    m_settings->set(&ViewValues::brushRadius, 0.0);
    press(Vec3::Zero());
    drag(Vec3::Zero(), Vec3(0.5F, 0.4F, 0.0F), 300);
    QTest::keyPress(m_view.get(), Qt::Key_E);
    // On the screen the pointer moves straight up beside the axis; in the world it goes around it.
    const QPointF from = *m_view->mainCamera().project({0.5F, 0.4F, 0.0F});
    for (int i = 1; i <= 60; ++i) {
        const QPointF place = from - QPointF(0, 2 * i);
        QMouseEvent event(QEvent::MouseMove, place, m_view->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(m_view.get(), &event);
        QTest::qWait(20);
    }
    QTest::keyRelease(m_view.get(), Qt::Key_E);
    QVERIFY(m_view->mainCamera().azimuth() > static_cast<float>(radians(30)));
    QVERIFY(m_view->isGestureActive());
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, (from - QPointF(0, 120)).toPoint());
    float farthestBack = 0.0F;
    for (InternodeId id = 0; id < m_document->tree().size(); ++id)
        farthestBack = std::max(farthestBack, std::abs(m_document->index().nodePosition(id).z()));
    QVERIFY(farthestBack > 0.2F);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void ViewportTest::orbitAndZoom_moveTheCameraAndLeaveTheTreeAlone()
{
    const Camera before = m_view->mainCamera();
    QTest::mousePress(m_view.get(), Qt::RightButton, {}, {300, 200});
    QTest::mouseRelease(m_view.get(), Qt::RightButton, {}, {360, 220});
    QVERIFY(m_view->mainCamera().azimuth() < before.azimuth());
    QVERIFY(m_view->mainCamera().elevation() > before.elevation());
    const QPointF place(320, 240);
    QWheelEvent event(place, m_view->mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(m_view.get(), &event);
    QVERIFY(m_view->mainCamera().distance() < before.distance());
    const float distance = m_view->mainCamera().distance();
    QTest::keyClick(m_view.get(), Qt::Key_Minus);
    QVERIFY(m_view->mainCamera().distance() > distance);
    QCOMPARE(alive(), 1U);
    QCOMPARE(m_document->undoStack().count(), 0);
}

void ViewportTest::frameAll_fliesToTheWholeTree()
{
    stroke(Vec3::Zero(), {0.0F, 3.0F, 0.0F}, 600);
    Camera away = m_view->mainCamera();
    away.setTarget({30.0F, 0.0F, 0.0F});
    m_view->setCamera(away);
    QTest::keyClick(m_view.get(), Qt::Key_F);
    QVERIFY(m_view->mainCamera().target().x() > 29.0F);
    QTRY_VERIFY(std::abs(m_view->mainCamera().target().x()) < 1.0F);
    const QRect visible = m_view->rect();
    for (InternodeId id = 0; id < m_document->tree().size(); ++id) {
        if (m_document->tree().isAlive(id))
            QTRY_VERIFY(visible.contains(at(m_document->index().nodePosition(id))));
    }
}

void ViewportTest::namedViews_turnAndKeepTargetAndDistance()
{
    stroke(Vec3::Zero(), {0.0F, 2.0F, 0.0F}, 400);
    Camera canvas = m_view->mainCamera();
    canvas.setTarget({0.2F, 1.7F, 0.1F});
    canvas.setDistance(2.5F);
    m_view->setCamera(canvas);
    for (const NamedView side :
         {NamedView::Side, NamedView::Top, NamedView::ThreeQuarter, NamedView::Front}) {
        m_view->showFrom(side);
        const Camera turned = canvas.turnedTo(side);
        QTRY_VERIFY(std::abs(m_view->mainCamera().elevation() - turned.elevation()) < 1e-4F &&
                    std::abs(std::remainder(m_view->mainCamera().azimuth() - turned.azimuth(),
                                            2.0F * std::numbers::pi_v<float>)) < 1e-4F);
        QVERIFY((m_view->mainCamera().target() - canvas.target()).norm() < 1e-4F);
        QVERIFY(std::abs(m_view->mainCamera().distance() - canvas.distance()) < 1e-4F);
    }
}

void ViewportTest::frameAllDuringATurn_comesToBothEnds()
{
    stroke(Vec3::Zero(), {0.0F, 3.0F, 0.0F}, 600);
    Camera away = m_view->mainCamera();
    away.setTarget({30.0F, 0.0F, 0.0F});
    m_view->setCamera(away);
    m_view->showFrom(NamedView::Side);
    QTRY_VERIFY(m_view->mainCamera().azimuth() > 0.2F);
    QTest::keyClick(m_view.get(), Qt::Key_F);
    QTRY_VERIFY(std::abs(m_view->mainCamera().azimuth() - static_cast<float>(radians(90))) < 1e-4F);
    QVERIFY(std::abs(m_view->mainCamera().target().x()) < 1.0F);
}

void ViewportTest::turnDuringAFlight_isKept()
{
    stroke(Vec3::Zero(), {0.0F, 3.0F, 0.0F}, 600);
    Camera away = m_view->mainCamera();
    away.setTarget({30.0F, 0.0F, 0.0F});
    m_view->setCamera(away);
    QTest::mousePress(m_view.get(), Qt::RightButton, {}, {200, 200});
    QTest::keyClick(m_view.get(), Qt::Key_F);
    QTest::qWait(60);
    const float azimuth = m_view->mainCamera().azimuth();
    QMouseEvent dragged(QEvent::MouseMove, {240.0, 200.0}, m_view->mapToGlobal(QPointF(240.0, 200.0)),
                        Qt::NoButton, Qt::RightButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_view.get(), &dragged);
    const float turned = m_view->mainCamera().azimuth();
    QVERIFY(std::abs(turned - azimuth) > 0.1F);
    QTRY_VERIFY(std::abs(m_view->mainCamera().target().x()) < 1.0F);
    QVERIFY(std::abs(m_view->mainCamera().azimuth() - turned) < 0.05F);
    QTest::mouseRelease(m_view.get(), Qt::RightButton, {}, {240, 200});
}

void ViewportTest::newTool_finishesTheGestureOfTheOld()
{
    QSignalSpy changed(m_view.get(), &Viewport::toolChanged);
    press(Vec3::Zero());
    drag(Vec3::Zero(), {0.0F, 1.0F, 0.0F}, 400);
    m_view->setTool(std::make_unique<BrushTool>(m_view->toolContext()));
    QVERIFY(alive() > 1U);
    QCOMPARE(changed.count(), 1);
    release({0.0F, 1.0F, 0.0F});
    QCOMPARE(m_document->undoStack().count(), 1);
}

void ViewportTest::picture_changesWithTheTreeAndComesToRest()
{
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 10000);
    const QImage seedling = m_view->grabFramebuffer();
    stroke(Vec3::Zero(), {0.0F, 3.0F, 0.0F}, 800);
    QVERIFY(!m_view->isAtRest());
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 20000);
    // The overlay without the brush of the hovering pointer
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(m_view.get(), &leave);
    const QImage tree = m_view->grabFramebuffer();
    QVERIFY(seedling != tree);
    m_document->undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 10000);
    QCOMPARE(m_view->grabFramebuffer(), seedling);
}

void ViewportTest::brushRadius_doesNotRedrawTheTree()
{
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 10000);
    m_settings->set(&ViewValues::brushRadius, 1.5);
    QVERIFY(m_view->isAtRest());
    m_settings->set(&ViewValues::groundShown, false);
    QVERIFY(!m_view->isAtRest());
}

void ViewportTest::window_canBeChanged()
{
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 10000);
    const QImage before = m_view->grabFramebuffer();
    QWidget window;
    window.resize(before.size() / m_view->devicePixelRatioF());
    m_view->setParent(&window);
    m_view->resize(window.size());
    m_view->show();
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 10000);
    QCOMPARE(m_view->grabFramebuffer(), before);
    m_view->setParent(nullptr);
}

void ViewportTest::samplesThatWaited_areAllDrawnAndOtherwiseTheNewestWillDo()
{
    for (const bool isFreehand : {true, false}) {
        auto made = std::make_unique<CountingTool>(m_view->toolContext(), isFreehand);
        CountingTool& tool = *made;
        m_view->setTool(std::move(made));
        const quint64 begun = 50'000;
        const auto send = [&](QEvent::Type type, int x, quint64 after) {
            const QPointF place(x, 200.0);
            QMouseEvent event(type, place, m_view->mapToGlobal(place),
                              type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                              Qt::NoModifier);
            event.setTimestamp(begun + after);
            QCoreApplication::sendEvent(m_view.get(), &event);
        };
        send(QEvent::MouseButtonPress, 100, 0);
        // The program is busy, and meanwhile the pointer moves.
        QTest::qSleep(200);
        for (int i = 1; i <= 10; ++i)
            send(QEvent::MouseMove, 100 + i, static_cast<quint64>(10 * i));
        QCOMPARE(tool.moves.size(), isFreehand ? std::size_t{10} : std::size_t{0});
        QTRY_COMPARE(tool.moves.size(), isFreehand ? std::size_t{10} : std::size_t{1});
        QCOMPARE(tool.moves.back(), QPointF(110.0, 200.0));
        // The last one is not lost if the button is released before.
        QTest::qSleep(100);
        send(QEvent::MouseMove, 120, 150);
        send(QEvent::MouseButtonRelease, 120, 160);
        QCOMPARE(tool.moves.back(), QPointF(120.0, 200.0));
    }
}

void ViewportTest::drawnLine_isInTheNextPicture()
{
    m_settings->set(&ViewValues::brushRadius, 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 10000);
    const QPoint from = at(Vec3::Zero());
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 12; ++i) {
        const QPoint place = from + QPoint(12 * i, -20 * i);
        QVERIFY2(isInNextPicture(*m_view, place, kPickedColour, [&] { moveHeld(place); }),
                 qPrintable(QString::number(i)));
    }
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, from + QPoint(144, -240));
}

void ViewportTest::secondView_givesDepthToWhatIsDrawnInIt()
{
    m_settings->set(&ViewValues::secondViewShown, true);
    m_settings->set(&ViewValues::brushRadius, 0.0);
    stroke(Vec3::Zero(), {0.0F, 2.0F, 0.0F}, 300);
    const SecondView& side = m_view->secondView();
    QVERIFY(m_view->rect().contains(side.rect()));
    // In the view from the right, the right is away from the viewer of the large one.
    const auto place = [&](const Vec3& point) {
        return (side.camera().project(point)->toPoint() + side.rect().topLeft());
    };
    const std::uint32_t trunk = alive();
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, place({0.0F, 1.4F, 0.0F}));
    for (int i = 1; i <= 20; ++i) {
        const float share = static_cast<float>(i) / 20.0F;
        QTest::mouseMove(m_view.get(), place({0.0F, 1.4F + 0.5F * share, -0.9F * share}));
        QTest::qWait(20);
    }
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, place({0.0F, 1.9F, -0.9F}));
    QVERIFY(alive() > trunk + 2);
    Box3 limb;
    for (InternodeId id = 0; id < m_document->tree().size(); ++id)
        limb.extend(m_document->index().nodePosition(id));
    QVERIFY2(limb.min().z() < -0.6F, qPrintable(QString::number(limb.min().z())));
    QVERIFY(limb.max().z() < 0.2F);
    QVERIFY(limb.max().x() < 0.2F && limb.min().x() > -0.2F);
    QCOMPARE(m_document->undoStack().count(), 2);

    // The pointer that comes back to the large view draws there again.
    const std::uint32_t before = alive();
    stroke({0.0F, 1.0F, 0.0F}, {0.8F, 1.4F, 0.0F}, 400);
    QVERIFY(alive() > before + 1);
    for (InternodeId id = 0; id < m_document->tree().size(); ++id)
        limb.extend(m_document->index().nodePosition(id));
    QVERIFY(limb.max().x() > 0.5F);
}

void ViewportTest::secondView_isPickedIn()
{
    m_settings->set(&ViewValues::secondViewShown, true);
    m_settings->set(&ViewValues::brushRadius, 0.0);
    stroke(Vec3::Zero(), {0.0F, 2.0F, 0.0F}, 300);
    m_view->setTool(std::make_unique<PruneTool>(m_view->toolContext()));
    const SecondView& side = m_view->secondView();
    const QPoint middle = side.camera().project({0.0F, 1.0F, 0.0F})->toPoint() + side.rect().topLeft();
    const std::uint32_t trunk = alive();
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, middle);
    QTRY_VERIFY(alive() < trunk);
    QCOMPARE(m_document->undoStack().count(), 2);
}

void ViewportTest::secondView_zoomsAndTurnsWithTheLargeOne()
{
    m_settings->set(&ViewValues::secondViewShown, true);
    const SecondView& side = m_view->secondView();
    const auto right = [&] { return static_cast<double>(side.camera().azimuth()); };
    const auto large = [&] { return static_cast<double>(m_view->mainCamera().azimuth()); };
    QVERIFY(std::abs(right() - large() - std::numbers::pi / 2.0) < 1e-6);
    const QPoint middle = side.rect().center();
    QTest::mousePress(m_view.get(), Qt::RightButton, {}, middle);
    QTest::mouseMove(m_view.get(), middle + QPoint(40, 0));
    QTest::mouseRelease(m_view.get(), Qt::RightButton, {}, middle + QPoint(40, 0));
    QVERIFY(std::abs(large()) > 0.1);
    QVERIFY(std::abs(right() - large() - std::numbers::pi / 2.0) < 1e-6);
    // The wheel over it does not move the tree sideways in the large view.
    const Vec3 target = m_view->mainCamera().target();
    const float distance = m_view->mainCamera().distance();
    QWheelEvent wheel(middle, m_view->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(m_view.get(), &wheel);
    QVERIFY(m_view->mainCamera().distance() < distance);
    QVERIFY((m_view->mainCamera().target() - target).norm() < 1e-5F);
}

void ViewportTest::secondView_needsRoom()
{
    QVERIFY(!m_view->secondView().isShown());
    m_settings->set(&ViewValues::secondViewShown, true);
    QVERIFY(m_view->secondView().isShown());
    m_view->setFrameMargins({200, 100, 200, 100});
    QVERIFY(!m_view->secondView().isShown());
    m_view->setFrameMargins({0, 0, 0, 0});
    QVERIFY(m_view->secondView().isShown());
    // It is drawn, and the large picture beside it stays the same.
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 20'000);
    const QImage with = m_view->grabFramebuffer();
    m_settings->set(&ViewValues::secondViewShown, false);
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 20'000);
    const QImage without = m_view->grabFramebuffer();
    QCOMPARE(with.copy(0, 0, 300, 480), without.copy(0, 0, 300, 480));
    QVERIFY(with != without);
}

void ViewportTest::hoverInASecondViewThatGoesAway_isOver()
{
    m_settings->set(&ViewValues::secondViewShown, true);
    const auto spheres = [&] {
        Overlay overlay;
        m_view->tool().paint(overlay);
        return overlay.spheres().size();
    };
    QTest::mouseMove(m_view.get(), m_view->secondView().rect().center());
    QTRY_COMPARE(spheres(), std::size_t{1});
    m_settings->set(&ViewValues::secondViewShown, false);
    QCOMPARE(spheres(), std::size_t{0});
}

void ViewportTest::sun_isDraggedAndNothingIsUndone()
{
    const ViewValues before = m_settings->values();
    const QPointF target(250.0, 180.0);
    pressSun();
    moveHeld(target + QPointF(60.0, -20.0));
    moveHeld(target);
    QVERIFY(isSunAt(target));
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, target.toPoint());
    QVERIFY(isSunAt(target));
    QVERIFY(m_settings->values().sunAzimuth < before.sunAzimuth);
    QVERIFY(m_settings->values().sunElevation < before.sunElevation);
    QCOMPARE(alive(), 1U);
    QCOMPARE(m_document->undoStack().count(), 0);
    // Elsewhere, and where no sun is shown, the pointer brushes.
    m_settings->set(&ViewValues::sunShown, false);
    const double azimuth = m_settings->values().sunAzimuth;
    pressSun();
    moveHeld(target + QPointF(-40.0, 0.0));
    QCOMPARE(m_settings->values().sunAzimuth, azimuth);
}

void ViewportTest::sun_goesBehindTheTreeBeyondTheRim()
{
    const QPointF rim(m_view->width() - 130.0, m_view->height() / 2.0 - 20.0);
    pressSun();
    moveHeld(rim + QPointF(50.0, 0.0));
    // East is to the right; behind the tree is north.
    const double azimuth = m_settings->values().sunAzimuth;
    QVERIFY2(azimuth > radians(95) && azimuth < radians(160), qPrintable(QString::number(degrees(azimuth))));
    QVERIFY(m_view->sunPlace().x() < rim.x());
    // Dragged down to the ground, the sun stays above the horizon.
    moveHeld(QPointF(rim.x(), m_view->height()));
    QVERIFY(m_settings->values().sunElevation >= kLeastSunElevation);
}

void ViewportTest::escape_putsTheSunBack()
{
    const ViewValues before = m_settings->values();
    pressSun();
    moveHeld({200.0, 150.0});
    QVERIFY(m_settings->values() != before);
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    QCOMPARE(m_settings->values(), before);
}

void ViewportTest::pinnedSun_staysOnTheScreen()
{
    const auto turn = [&](float angle) {
        Camera camera = m_view->mainCamera();
        camera.orbit(angle, 0.0F);
        m_view->setCamera(camera);
    };
    turn(0.4F);
    const QPointF place = m_view->sunPlace();
    m_settings->set(&ViewValues::sunPinned, true);
    QVERIFY(isSunAt(place));
    turn(0.5F);
    QVERIFY(isSunAt(place));
    m_settings->set(&ViewValues::sunPinned, false);
    QVERIFY(isSunAt(place));
    turn(0.5F);
    QVERIFY(!isSunAt(place));
}

void ViewportTest::heldSun_staysUnderThePointerWhileTheTreeTurns()
{
    const QPointF target(420.0, 150.0);
    pressSun();
    moveHeld(target);
    const double azimuth = m_settings->values().sunAzimuth;
    Camera camera = m_view->mainCamera();
    camera.orbit(0.6F, 0.0F);
    m_view->setCamera(camera);
    QTRY_VERIFY(isSunAt(target));
    QVERIFY(std::abs(m_settings->values().sunAzimuth - azimuth - 0.6) < 0.01);
}

static const TestClass<ViewportTest> viewportTest;

#include "ViewportTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/GestureReader.h"

#include "model/base/Vector.h"
#include "tests/support/TestClasses.h"
#include "views/input/HeldKeys.h"
#include "views/input/PointerReader.h"

#include <QPointingDevice>
#include <QTabletEvent>
#include <QTest>
#include <QWidget>

#include <memory>

using namespace espalier;

/// A widget that turns pointer events into gestures and logs them.
class Pad : public QWidget, public GestureTarget {
public:
    Pad()
    {
        setAttribute(Qt::WA_AcceptTouchEvents);
        setMouseTracking(true);
        resize(400, 300);
    }

    PointerReader pointers;
    GestureReader gestures{*this};
    QStringList log;
    std::vector<PointerSample> samples;
    QPointF orbited;
    QPointF panned;
    double magnified = 1.0;
    QList<int> taps;           ///< Numbers of fingers
    double fingersAbove = 0.0; ///< px; the tool takes further fingers there

protected:
    bool event(QEvent* event) override
    {
        const auto read = pointers.read(*event);
        if (read.empty() && event->type() != QEvent::TouchUpdate)
            return QWidget::event(event);
        gestures.read(read);
        event->accept();
        return true;
    }

    void note(const char* what, const PointerSample& sample)
    {
        log << what;
        samples.push_back(sample);
    }
    void toolBegins(const PointerSample& sample) override { note("begin", sample); }
    void toolMoves(const PointerSample& sample) override { note("move", sample); }
    void toolEnds(const PointerSample& sample) override { note("end", sample); }
    void toolIsFinished() override { log << "finish"; }
    void toolIsCancelled() override { log << "cancel"; }
    bool toolTakesFinger(const PointerSample& sample) override { return sample.position.y() < fingersAbove; }
    void toolHovers(const PointerSample& sample) override { note("hover", sample); }
    void budIsAsked(const PointerSample& sample) override { note("bud", sample); }
    void menuIsAsked(const PointerSample& sample) override { note("menu", sample); }
    void fingersTap(int fingers) override { taps << fingers; }
    void orbitBy(const QPointF& distance) override { orbited += distance; }
    void panBy(const QPointF& distance) override { panned += distance; }
    void magnify(double factor, const QPointF& about) override
    {
        Q_UNUSED(about)
        magnified *= factor;
    }
};

class GestureReaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_device.reset(QTest::createTouchDevice()); }
    void init();
    void cleanup() { m_pad.reset(); }

    void oneFinger_isTheTool();
    void twoFingers_panAndPinch();
    void threeFingers_rotate();
    void tapsOfSeveralFingers_areTold();
    void slowOrMovingFingers_tapNot();
    void secondFinger_cancelsTheTool();
    void fingersThatLinger_doNothing();
    void fingersThatTheToolTakes_areItsOwn();
    void fingersThatComeAtOnce_areTheToolsIfItTakesAll();
    void cancelledTouch_endsTheStroke_data();
    void cancelledTouch_endsTheStroke();
    void mouseLeft_isTheTool();
    void mouseButtons_orbitAndPan_data();
    void mouseButtons_orbitAndPan();
    void schemes_giveTheButtonsOtherMeanings_data();
    void schemes_giveTheButtonsOtherMeanings();
    void pressureCurve_bendsWhatAPenTells();
    void spaceBar_makesTheLeftButtonPan();
    void hover_isToldToTheTool();
    void cancel_waitsForTheRelease();
    void finish_keepsTheStrokeAndWaitsForTheRelease();
    void finish_leavesTheCameraInTheHand();
    void lostRelease_doesNotBlockTheNextPress_data();
    void lostRelease_doesNotBlockTheNextPress();
    void penThatLeaves_endsItsStroke();
    void pen_tellsPressureAndTilt();
    void palm_isIgnoredWhileThePenIsDown();
    void palm_thatCameFirstIsTakenBack();
    void pen_endsTheStrokeOfAFinger();
    void penInReach_keepsFingersOut();
    void rightClick_asksForAMenu_data();
    void rightClick_asksForAMenu();
    void time_neverRunsBack();
    void stripFinger_rotatesWhileAnotherDraws();
    void altClick_asksForABud();
    void heldKeys_askForMotion();
    void heldKeys_leaveShortcutsAlone();

private:
    void sendPen(QEvent::Type type, const QPointF& position, double pressure, Qt::MouseButtons buttons);

    std::unique_ptr<QPointingDevice> m_device;
    std::unique_ptr<Pad> m_pad;
};

void GestureReaderTest::init()
{
    m_pad = std::make_unique<Pad>();
    m_pad->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_pad.get()));
    m_pad->log.clear();
    m_pad->samples.clear();
}

void GestureReaderTest::sendPen(QEvent::Type type, const QPointF& position, double pressure,
                                Qt::MouseButtons buttons)
{
    static const QPointingDevice stylus(
        "test stylus", 77, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
    QTabletEvent event(type, &stylus, position, m_pad->mapToGlobal(position), pressure, 30.0F, -20.0F, 0.0F,
                       0.0, 0.0F, Qt::NoModifier, type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                       buttons);
    QCoreApplication::sendEvent(m_pad.get(), &event);
}

void GestureReaderTest::oneFinger_isTheTool()
{
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {50, 60});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {70, 65});
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {90, 70});
    QCOMPARE(m_pad->log, (QStringList{"begin", "move", "end"}));
    QCOMPARE(m_pad->samples[0].device, PointerDevice::Finger);
    QCOMPARE(m_pad->samples[0].position, QPointF(50, 60));
    QCOMPARE(m_pad->samples[1].position, QPointF(70, 65));
    QCOMPARE(m_pad->samples[2].position, QPointF(90, 70));
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::twoFingers_panAndPinch()
{
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100}).press(1, {200, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {110, 120}).move(1, {210, 120});
    QCOMPARE(m_pad->panned, QPointF(10, 20));
    QCOMPARE(m_pad->magnified, 1.0);
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {60, 120}).move(1, {260, 120});
    QCOMPARE(m_pad->panned, QPointF(10, 20));
    QCOMPARE(m_pad->magnified, 2.0);
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {60, 120}).release(1, {260, 120});
    QCOMPARE(m_pad->log, QStringList());
    QVERIFY(m_pad->orbited.isNull());
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::threeFingers_rotate()
{
    QTest::touchEvent(m_pad.get(), m_device.get())
        .press(0, {100, 100})
        .press(1, {200, 100})
        .press(2, {150, 150});
    QTest::touchEvent(m_pad.get(), m_device.get())
        .move(0, {130, 106})
        .move(1, {230, 106})
        .move(2, {180, 156});
    QTest::touchEvent(m_pad.get(), m_device.get())
        .release(0, {130, 106})
        .release(1, {230, 106})
        .release(2, {180, 156});
    QVERIFY(QLineF(m_pad->orbited, QPointF(30, 6)).length() < 1e-6);
    QVERIFY(m_pad->panned.isNull());
    QCOMPARE(m_pad->log, QStringList());
}

void GestureReaderTest::tapsOfSeveralFingers_areTold()
{
    for (int count = 1; count <= 5; ++count) {
        // One after another, as they come in life, with a tremble.
        for (int i = 0; i < count; ++i) {
            auto event = QTest::touchEvent(m_pad.get(), m_device.get());
            for (int before = 0; before < i; ++before)
                event.stationary(before);
            event.press(i, {50 + 60 * i, 100});
        }
        {
            auto event = QTest::touchEvent(m_pad.get(), m_device.get());
            for (int i = 0; i < count; ++i)
                event.move(i, {53 + 60 * i, 102});
        }
        for (int i = 0; i < count; ++i) {
            auto event = QTest::touchEvent(m_pad.get(), m_device.get());
            event.release(i, {53 + 60 * i, 102});
            for (int after = i + 1; after < count; ++after)
                event.stationary(after);
        }
        QVERIFY(!m_pad->gestures.isBusy());
    }
    QCOMPARE(m_pad->taps, (QList<int>{2, 3, 4}));
    // The first finger's stroke leaves nothing.
    QCOMPARE(m_pad->log.count("begin"), 5);
    QCOMPARE(m_pad->log.count("cancel"), 4);
}

void GestureReaderTest::slowOrMovingFingers_tapNot()
{
    const auto touch = [&](const QPoint& move, int wait) {
        QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100}).press(1, {200, 100});
        QTest::qWait(wait);
        QTest::touchEvent(m_pad.get(), m_device.get()).move(0, QPoint(100, 100) - move).move(1, {200, 100});
        QTest::touchEvent(m_pad.get(), m_device.get())
            .release(0, QPoint(100, 100) - move)
            .release(1, {200, 100});
    };
    touch({30, 0}, 0); // A pinch
    QVERIFY(m_pad->magnified > 1.1);
    touch({0, 0}, static_cast<int>(1000 * GestureReader::kTapTime) + 100);
    QCOMPARE(m_pad->taps, QList<int>());
    // Fingers that a tool uses work.
    m_pad->fingersAbove = 300.0;
    touch({0, 0}, 0);
    QCOMPARE(m_pad->taps, QList<int>());
    m_pad->fingersAbove = 0.0;
    touch({0, 0}, 0);
    QCOMPARE(m_pad->taps, QList<int>{2});
}

void GestureReaderTest::secondFinger_cancelsTheTool()
{
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {104, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).stationary(0).press(1, {200, 100});
    QCOMPARE(m_pad->log, (QStringList{"begin", "move", "cancel"}));
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {114, 100}).move(1, {210, 100});
    QCOMPARE(m_pad->panned, QPointF(10, 0));
    QTest::touchEvent(m_pad.get(), m_device.get()).stationary(0).stationary(1).press(2, {150, 180});
    QTest::touchEvent(m_pad.get(), m_device.get())
        .move(0, {114, 130})
        .move(1, {210, 130})
        .move(2, {150, 210});
    QVERIFY(QLineF(m_pad->orbited, QPointF(0, 30)).length() < 1e-6);
    QTest::touchEvent(m_pad.get(), m_device.get())
        .release(0, {114, 130})
        .release(1, {210, 130})
        .release(2, {150, 210});
    QCOMPARE(m_pad->log, (QStringList{"begin", "move", "cancel"}));
}

void GestureReaderTest::fingersThatLinger_doNothing()
{
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100}).press(1, {200, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).stationary(0).release(1, {200, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {50, 50});
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {50, 50});
    QCOMPARE(m_pad->log, QStringList());
    QVERIFY(m_pad->panned.isNull());
    // The next finger works with the tool again.
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100});
    QCOMPARE(m_pad->log, (QStringList{"begin"}));
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {100, 100});
}

void GestureReaderTest::fingersThatTheToolTakes_areItsOwn()
{
    m_pad->fingersAbove = 150.0;
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 200});
    QTest::touchEvent(m_pad.get(), m_device.get()).stationary(0).press(1, {200, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {110, 200}).move(1, {190, 100});
    QCOMPARE(m_pad->log, (QStringList{"begin", "begin", "move", "move"}));
    QVERIFY(m_pad->samples[0].id != m_pad->samples[1].id);
    QCOMPARE(m_pad->samples[2].id, m_pad->samples[0].id);
    QCOMPARE(m_pad->samples[3].id, m_pad->samples[1].id);
    QVERIFY(m_pad->panned.isNull());
    // The first finger that is lifted ends the gesture; the other one stays down.
    QTest::touchEvent(m_pad.get(), m_device.get()).stationary(0).release(1, {190, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {20, 20});
    QCOMPARE(m_pad->log, (QStringList{"begin", "begin", "move", "move", "end"}));
    QCOMPARE(m_pad->samples[4].id, m_pad->samples[1].id);
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {20, 20});
    QVERIFY(!m_pad->gestures.isBusy());

    // If the tool refuses a finger, all fingers move the camera.
    m_pad->log.clear();
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).stationary(0).press(1, {200, 200});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {110, 100}).move(1, {210, 200});
    QCOMPARE(m_pad->log, (QStringList{"begin", "cancel"}));
    QCOMPARE(m_pad->panned, QPointF(10.0, 0.0));
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {110, 100}).release(1, {210, 200});
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::fingersThatComeAtOnce_areTheToolsIfItTakesAll()
{
    m_pad->fingersAbove = 150.0;
    QTest::touchEvent(m_pad.get(), m_device.get())
        .press(0, {100, 100})
        .press(1, {200, 100})
        .press(2, {150, 50});
    QCOMPARE(m_pad->log, (QStringList{"begin", "begin", "begin"}));
    QTest::touchEvent(m_pad.get(), m_device.get())
        .release(0, {100, 100})
        .release(1, {200, 100})
        .release(2, {150, 50});
    QCOMPARE(m_pad->log.last(), QString("end"));
    QCOMPARE(m_pad->log.size(), 4);
    QVERIFY(!m_pad->gestures.isBusy());

    m_pad->log.clear();
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100}).press(1, {200, 200});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {100, 110}).move(1, {200, 210});
    QCOMPARE(m_pad->log, (QStringList{"begin", "cancel"}));
    QCOMPARE(m_pad->panned, QPointF(0.0, 10.0));
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {100, 110}).release(1, {200, 210});
}

void GestureReaderTest::cancelledTouch_endsTheStroke_data()
{
    QTest::addColumn<bool>("namesThePoint");
    // Qt's event for a touch that the system takes has no points.
    QTest::newRow("without points") << false;
    QTest::newRow("with its point") << true;
}

void GestureReaderTest::cancelledTouch_endsTheStroke()
{
    QFETCH(bool, namesThePoint);
    QList<QEventPoint> points;
    if (namesThePoint)
        points.append(QEventPoint(0, QEventPoint::State::Released, {100, 100}, {100, 100}));
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {100, 100});
    QTouchEvent event(QEvent::TouchCancel, m_device.get(), Qt::NoModifier, points);
    QCoreApplication::sendEvent(m_pad.get(), &event);
    QCOMPARE(m_pad->log, (QStringList{"begin", "finish"}));
    QVERIFY(!m_pad->gestures.isBusy());
    // The next finger works with the tool again.
    QTest::touchEvent(m_pad.get(), m_device.get()).press(1, {120, 100});
    QTest::touchEvent(m_pad.get(), m_device.get()).release(1, {120, 100});
    QCOMPARE(m_pad->log, (QStringList{"begin", "finish", "begin", "end"}));
}

void GestureReaderTest::mouseLeft_isTheTool()
{
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, {50, 60});
    QTest::mouseMove(m_pad.get(), {80, 90});
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, {81, 90});
    m_pad->log.removeAll("hover");
    QCOMPARE(m_pad->log.first(), "begin");
    QCOMPARE(m_pad->log.last(), "end");
    QVERIFY(m_pad->log.contains("move"));
    QCOMPARE(m_pad->samples.back().pressure, 1.0);
}

void GestureReaderTest::mouseButtons_orbitAndPan_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::addColumn<bool>("orbits");
    QTest::newRow("middle") << Qt::MiddleButton << Qt::KeyboardModifiers() << true;
    QTest::newRow("right") << Qt::RightButton << Qt::KeyboardModifiers() << true;
    QTest::newRow("Alt+left") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::AltModifier) << true;
    QTest::newRow("Shift+middle") << Qt::MiddleButton << Qt::KeyboardModifiers(Qt::ShiftModifier) << false;
}

void GestureReaderTest::schemes_giveTheButtonsOtherMeanings_data()
{
    QTest::addColumn<MouseScheme>("scheme");
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::addColumn<QString>("what");
    const Qt::KeyboardModifiers none;
    const Qt::KeyboardModifiers alt(Qt::AltModifier);
    const Qt::KeyboardModifiers shift(Qt::ShiftModifier);
    const Qt::KeyboardModifiers ctrl(Qt::ControlModifier);
    using enum MouseScheme;
    QTest::newRow("Blender left") << Blender << Qt::LeftButton << none << "tool";
    QTest::newRow("Blender Alt+left") << Blender << Qt::LeftButton << alt << "orbit";
    QTest::newRow("Blender middle") << Blender << Qt::MiddleButton << none << "orbit";
    QTest::newRow("Blender Shift+middle") << Blender << Qt::MiddleButton << shift << "pan";
    QTest::newRow("Blender Ctrl+middle") << Blender << Qt::MiddleButton << ctrl << "zoom";
    QTest::newRow("Blender right") << Blender << Qt::RightButton << none << "";
    QTest::newRow("Maya left") << Maya << Qt::LeftButton << none << "tool";
    QTest::newRow("Maya Alt+left") << Maya << Qt::LeftButton << alt << "orbit";
    QTest::newRow("Maya middle") << Maya << Qt::MiddleButton << none << "";
    QTest::newRow("Maya Alt+middle") << Maya << Qt::MiddleButton << alt << "pan";
    QTest::newRow("Maya right") << Maya << Qt::RightButton << none << "";
    QTest::newRow("Maya Alt+right") << Maya << Qt::RightButton << alt << "zoom";
}

void GestureReaderTest::schemes_giveTheButtonsOtherMeanings()
{
    QFETCH(MouseScheme, scheme);
    QFETCH(Qt::MouseButton, button);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    QFETCH(QString, what);
    m_pad->gestures.setScheme(scheme);
    QTest::mousePress(m_pad.get(), button, modifiers, {50, 60});
    QTest::mouseRelease(m_pad.get(), button, modifiers, {90, 45});
    QCOMPARE(m_pad->log.contains("begin"), what == "tool");
    QCOMPARE(m_pad->orbited, what == "orbit" ? QPointF(40, -15) : QPointF());
    QCOMPARE(m_pad->panned, what == "pan" ? QPointF(40, -15) : QPointF());
    // To the right and upwards is nearer.
    QCOMPARE(m_pad->magnified > 1.2, what == "zoom");
    QCOMPARE(m_pad->magnified == 1.0, what != "zoom");
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::pressureCurve_bendsWhatAPenTells()
{
    m_pad->pointers.setPressureExponent(0.5);
    sendPen(QEvent::TabletPress, {40, 50}, 0.25, Qt::LeftButton);
    sendPen(QEvent::TabletMove, {45, 50}, 1.0, Qt::LeftButton);
    sendPen(QEvent::TabletRelease, {46, 50}, 0.0, Qt::NoButton);
    QCOMPARE(m_pad->samples[0].pressure, 0.5);
    QCOMPARE(m_pad->samples[1].pressure, 1.0);
    QCOMPARE(m_pad->samples[2].pressure, 0.0);
}

void GestureReaderTest::mouseButtons_orbitAndPan()
{
    QFETCH(Qt::MouseButton, button);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    QFETCH(bool, orbits);
    QTest::mousePress(m_pad.get(), button, modifiers, {50, 60});
    QTest::mouseRelease(m_pad.get(), button, modifiers, {90, 75});
    QCOMPARE(m_pad->orbited, orbits ? QPointF(40, 15) : QPointF());
    QCOMPARE(m_pad->panned, orbits ? QPointF() : QPointF(40, 15));
    QVERIFY(!m_pad->log.contains("begin"));
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::spaceBar_makesTheLeftButtonPan()
{
    m_pad->gestures.setPanKey(true);
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, {50, 60});
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, {55, 61});
    QCOMPARE(m_pad->panned, QPointF(5, 1));
    QVERIFY(!m_pad->log.contains("begin"));
}

void GestureReaderTest::hover_isToldToTheTool()
{
    QMouseEvent event(QEvent::MouseMove, {30, 40}, m_pad->mapToGlobal(QPointF(30, 40)), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_pad.get(), &event);
    QCOMPARE(m_pad->log.last(), "hover");
    QCOMPARE(m_pad->samples.back().position, QPointF(30, 40));
}

void GestureReaderTest::cancel_waitsForTheRelease()
{
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, {50, 60});
    m_pad->gestures.cancel();
    QVERIFY(m_pad->gestures.isBusy());
    m_pad->log.clear();
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, {55, 61});
    QCOMPARE(m_pad->log, QStringList());
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::finish_keepsTheStrokeAndWaitsForTheRelease()
{
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, {50, 60});
    m_pad->gestures.finish();
    m_pad->gestures.finish();
    QVERIFY(m_pad->log.endsWith("finish"));
    QCOMPARE(m_pad->log.count("finish"), 1);
    m_pad->log.clear();
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, {55, 61});
    QCOMPARE(m_pad->log, QStringList());
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::finish_leavesTheCameraInTheHand()
{
    QTest::mousePress(m_pad.get(), Qt::RightButton, {}, {50, 60});
    m_pad->gestures.finish();
    QTest::mouseRelease(m_pad.get(), Qt::RightButton, {}, {90, 75});
    QCOMPARE(m_pad->orbited, QPointF(40, 15));
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::lostRelease_doesNotBlockTheNextPress_data()
{
    QTest::addColumn<QString>("next");
    for (const char* next : {"mouse", "pen", "finger"})
        QTest::newRow(next) << QString::fromLatin1(next);
}

void GestureReaderTest::lostRelease_doesNotBlockTheNextPress()
{
    QFETCH(QString, next);
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, {50, 60});
    // A dialog has got the release.
    m_pad->gestures.finish();
    m_pad->log.clear();
    if (next == "mouse") {
        QMouseEvent press(QEvent::MouseButtonPress, {80, 80}, m_pad->mapToGlobal(QPointF(80, 80)),
                          Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_pad.get(), &press);
    } else if (next == "pen") {
        sendPen(QEvent::TabletPress, {80, 80}, 0.5, Qt::LeftButton);
    } else {
        QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {80, 80});
    }
    QCOMPARE(m_pad->log, QStringList{"begin"});
    if (next == "finger")
        QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {80, 80});
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, {80, 80});
}

void GestureReaderTest::penThatLeaves_endsItsStroke()
{
    sendPen(QEvent::TabletPress, {40, 50}, 0.5, Qt::LeftButton);
    sendPen(QEvent::TabletMove, {60, 50}, 0.5, Qt::LeftButton);
    m_pad->gestures.setPenInReach(false, m_pad->pointers.now());
    QCOMPARE(m_pad->log, (QStringList{"begin", "move", "finish"}));
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::pen_tellsPressureAndTilt()
{
    sendPen(QEvent::TabletPress, {40, 50}, 0.25, Qt::LeftButton);
    sendPen(QEvent::TabletMove, {45, 50}, 0.75, Qt::LeftButton);
    sendPen(QEvent::TabletRelease, {46, 50}, 0.0, Qt::NoButton);
    QCOMPARE(m_pad->log, (QStringList{"begin", "move", "end"}));
    QCOMPARE(m_pad->samples[0].device, PointerDevice::Pen);
    QCOMPARE(m_pad->samples[0].pressure, 0.25);
    QCOMPARE(m_pad->samples[1].pressure, 0.75);
    QVERIFY(QLineF(m_pad->samples[1].tilt, QPointF(radians(30), radians(-20))).length() < 1e-6);
}

void GestureReaderTest::palm_isIgnoredWhileThePenIsDown()
{
    sendPen(QEvent::TabletPress, {40, 50}, 0.5, Qt::LeftButton);
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {200, 200});
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {210, 200}).press(1, {220, 220});
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {210, 200}).release(1, {220, 220});
    sendPen(QEvent::TabletRelease, {60, 50}, 0.0, Qt::NoButton);
    QCOMPARE(m_pad->log, (QStringList{"begin", "end"}));
    QVERIFY(m_pad->panned.isNull());
    QVERIFY(!m_pad->gestures.isBusy());
}

void GestureReaderTest::palm_thatCameFirstIsTakenBack()
{
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {200, 200});
    sendPen(QEvent::TabletPress, {40, 50}, 0.5, Qt::LeftButton);
    QCOMPARE(m_pad->log, (QStringList{"begin", "cancel", "begin"}));
    QCOMPARE(m_pad->samples.back().device, PointerDevice::Pen);
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {220, 200});
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {220, 200});
    sendPen(QEvent::TabletRelease, {40, 50}, 0.0, Qt::NoButton);
    QCOMPARE(m_pad->log, (QStringList{"begin", "cancel", "begin", "end"}));
}

void GestureReaderTest::pen_endsTheStrokeOfAFinger()
{
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {200, 200});
    QTest::qWait(static_cast<int>(1000.0 * GestureReader::kPalmTime) + 50);
    QTest::touchEvent(m_pad.get(), m_device.get()).move(0, {240, 200});
    sendPen(QEvent::TabletMove, {40, 50}, 0.0, Qt::NoButton);
    QCOMPARE(m_pad->log, (QStringList{"begin", "move", "finish", "hover"}));
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {240, 200});
    QCOMPARE(m_pad->log, (QStringList{"begin", "move", "finish", "hover"}));
}

void GestureReaderTest::penInReach_keepsFingersOut()
{
    m_pad->gestures.setPenInReach(true, m_pad->pointers.now());
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {200, 200});
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {200, 200});
    QCOMPARE(m_pad->log, QStringList());
    m_pad->gestures.setPenInReach(false, m_pad->pointers.now());
    QTest::touchEvent(m_pad.get(), m_device.get()).press(0, {200, 200});
    QTest::touchEvent(m_pad.get(), m_device.get()).release(0, {200, 200});
    QCOMPARE(m_pad->log, (QStringList{"begin", "end"}));
}

void GestureReaderTest::stripFinger_rotatesWhileAnotherDraws()
{
    m_pad->gestures.setStrip({0.0, 270.0, 400.0, 30.0});
    const auto touch = [&] { return QTest::touchEvent(m_pad.get(), m_device.get()); };
    touch().press(0, {50, 285});
    QVERIFY(m_pad->log.isEmpty());
    touch().stationary(0).press(1, {200, 100});
    touch().move(0, {80, 290}).move(1, {210, 90});
    touch().move(0, {110, 200}).move(1, {220, 80});
    QCOMPARE(m_pad->orbited, QPointF(60.0, 0.0));
    touch().stationary(0).release(1, {220, 80});
    QCOMPARE(m_pad->log, QStringList({"begin", "move", "move", "end"}));
    touch().move(0, {100, 200});
    touch().release(0, {100, 200});
    QCOMPARE(m_pad->orbited, QPointF(50.0, 0.0));
    QCOMPARE(m_pad->panned, QPointF());
    QVERIFY(!m_pad->gestures.isBusy());
    // By mouse, too.
    QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, {50, 290});
    QTest::mouseMove(m_pad.get(), {90, 250});
    QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, {90, 250});
    QCOMPARE(m_pad->orbited, QPointF(90.0, 0.0));
    QCOMPARE(m_pad->log.count("begin"), 1);
}

void GestureReaderTest::altClick_asksForABud()
{
    QTest::mouseClick(m_pad.get(), Qt::LeftButton, Qt::AltModifier, {50, 60});
    QCOMPARE(m_pad->log, QStringList{"bud"});
    QCOMPARE(m_pad->samples.back().position, QPointF(50, 60));
    QCOMPARE(m_pad->orbited, QPointF());
}

void GestureReaderTest::rightClick_asksForAMenu_data()
{
    QTest::addColumn<MouseScheme>("scheme");
    QTest::newRow("Espalier") << MouseScheme::Espalier;
    QTest::newRow("Blender") << MouseScheme::Blender;
    QTest::newRow("Maya") << MouseScheme::Maya;
}

void GestureReaderTest::rightClick_asksForAMenu()
{
    QFETCH(const MouseScheme, scheme);
    m_pad->gestures.setScheme(scheme);
    QTest::mouseClick(m_pad.get(), Qt::RightButton, {}, {50, 60});
    QCOMPARE(m_pad->log, QStringList{QStringLiteral("menu")});
    QCOMPARE(m_pad->samples.back().position, QPointF(50, 60));
    QVERIFY(!m_pad->gestures.isBusy());
    // A drag does not, and a click with a key does not either.
    m_pad->log.clear();
    QTest::mousePress(m_pad.get(), Qt::RightButton, {}, {50, 60});
    QTest::mouseMove(m_pad.get(), {90, 60});
    QTest::mouseRelease(m_pad.get(), Qt::RightButton, {}, {90, 60});
    QTest::mouseClick(m_pad.get(), Qt::MiddleButton, {}, {50, 60});
    QVERIFY2(!m_pad->log.contains(QStringLiteral("menu")), qPrintable(m_pad->log.join(QLatin1Char(' '))));
}

void GestureReaderTest::time_neverRunsBack()
{
    const auto send = [&](quint64 timestamp) {
        QMouseEvent event(QEvent::MouseMove, {30, 40}, m_pad->mapToGlobal(QPointF(30, 40)), Qt::NoButton,
                          Qt::NoButton, Qt::NoModifier);
        event.setTimestamp(timestamp);
        QCoreApplication::sendEvent(m_pad.get(), &event);
        return m_pad->samples.back().time;
    };
    double last = send(5'000'000);
    for (const quint64 timestamp : {5'000'016ULL, 5'000'010ULL, 3ULL, 900'000'000ULL, 5'000'032ULL}) {
        const double time = send(timestamp);
        QVERIFY(time >= last);
        QVERIFY(time <= m_pad->pointers.now());
        last = time;
    }
}

void GestureReaderTest::heldKeys_askForMotion()
{
    HeldKeys keys;
    QVERIFY(keys.press(Qt::Key_Right, {}));
    QVERIFY(keys.motion().orbit.x() > 0.0);
    QVERIFY(keys.press(Qt::Key_Q, {}));
    QVERIFY(keys.motion().orbit.isNull());
    QVERIFY(keys.release(Qt::Key_Q));
    QVERIFY(keys.release(Qt::Key_Right));
    QVERIFY(!keys.release(Qt::Key_Right));
    QVERIFY(!keys.isAnyHeld());
    QVERIFY(keys.press(Qt::Key_Up, Qt::ShiftModifier));
    QVERIFY(keys.motion().orbit.isNull());
    QVERIFY(!keys.motion().pan.isNull());
    QVERIFY(keys.press(Qt::Key_Plus, Qt::ShiftModifier));
    QVERIFY(keys.motion().zoom > 0.0);
}

void GestureReaderTest::heldKeys_leaveShortcutsAlone()
{
    HeldKeys keys;
    QVERIFY(!keys.press(Qt::Key_E, Qt::ControlModifier));
    QVERIFY(!keys.press(Qt::Key_Left, Qt::AltModifier));
    QVERIFY(!keys.press(Qt::Key_B, {}));
    QVERIFY(!keys.isAnyHeld());
}

static const test::TestClass<GestureReaderTest> gestureReaderTest;

#include "GestureReaderTest.moc"

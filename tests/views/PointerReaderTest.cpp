// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/PointerReader.h"

#include "tests/support/TestClasses.h"

#include <QMouseEvent>
#include <QTest>

namespace espalier::test {

/// The times of pointer samples: of events that wait because the program is busy, and of events with made-up
/// timestamps.
class PointerReaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void lateEvents_keepTheirPace();
    void restBetweenEvents_movesTheClock();
    void eventsThatWait_areNoRest();
    void wrongClocks_areCorrected();
};

namespace {

/// Time of an event's sample, s.
double read(PointerReader& reader, QEvent::Type type, quint64 stamp)
{
    const bool isDown = type != QEvent::MouseButtonRelease;
    QMouseEvent event(type, QPointF(5.0, 5.0), QPointF(5.0, 5.0),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      isDown ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
    event.setTimestamp(stamp);
    return reader.read(event).front().time;
}

} // namespace

void PointerReaderTest::lateEvents_keepTheirPace()
{
    PointerReader reader;
    for (const int busy : {0, 60, 300}) {
        const double begun = read(reader, QEvent::MouseButtonPress, 1000);
        double last = begun;
        for (quint64 stamp = 1020; stamp < 1200; stamp += 20) {
            if (stamp == 1060)
                QTest::qSleep(busy);
            const double time = read(reader, QEvent::MouseMove, stamp);
            QVERIFY(qAbs(time - last - 0.02) < 1e-9);
            last = time;
        }
        QVERIFY(qAbs(read(reader, QEvent::MouseButtonRelease, 1200) - begun - 0.2) < 1e-9);
    }
}

void PointerReaderTest::restBetweenEvents_movesTheClock()
{
    PointerReader reader;
    const double begun = read(reader, QEvent::MouseButtonPress, 1000);
    for (int i = 0; i < 20; ++i) {
        QTest::qSleep(20);
        reader.rest();
    }
    // The stamps say that no time went by, the ticks that 0.4 s did.
    QVERIFY(read(reader, QEvent::MouseMove, 1001) - begun > 0.25);
}

void PointerReaderTest::eventsThatWait_areNoRest()
{
    PointerReader reader;
    const double begun = read(reader, QEvent::MouseButtonPress, 1000);
    QTest::qSleep(400);
    // A tick after a long picture, before the events that came meanwhile.
    QVERIFY(reader.rest() < begun + 0.06);
    QVERIFY(qAbs(read(reader, QEvent::MouseMove, 1016) - begun - 0.016) < 1e-9);
}

void PointerReaderTest::wrongClocks_areCorrected()
{
    PointerReader reader;
    double last = 0.0;
    for (const quint64 stamp : {quint64(5), quint64(900'000), quint64(3), quint64(0), quint64(50'000)}) {
        const double pressed = read(reader, QEvent::MouseButtonPress, stamp);
        QVERIFY(pressed >= last);
        QVERIFY(pressed <= reader.now() + 1e-6);
        last = read(reader, QEvent::MouseButtonRelease, stamp + 10);
        QVERIFY(qAbs(last - pressed - 0.01) < 1e-9);
        QTest::qSleep(20);
    }
}

const TestClass<PointerReaderTest> pointerReaderTest;

} // namespace espalier::test

#include "PointerReaderTest.moc"

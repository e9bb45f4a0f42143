// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/StrokeStabiliser.h"

#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class StrokeStabiliserTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void off_changesNothing();
    void distance_keepsTremblingOut();
    void delay_comesLaterAndComes();
};

namespace {

PointerSample sampleAt(double x, double y, double time)
{
    PointerSample sample;
    sample.position = QPointF(x, y);
    sample.time = time;
    return sample;
}

} // namespace

void StrokeStabiliserTest::off_changesNothing()
{
    StrokeStabiliser stabiliser;
    stabiliser.begin(sampleAt(3.0, 4.0, 1.0));
    for (int i = 1; i < 30; ++i) {
        const PointerSample pointer = sampleAt(3.0 + i * i, 4.0 - 7.0 * i, 1.0 + 0.01 * i);
        QCOMPARE(stabiliser.move(pointer).position, pointer.position);
    }
    QVERIFY(!stabiliser.rest(9.0));
}

void StrokeStabiliserTest::distance_keepsTremblingOut()
{
    StrokeStabiliser stabiliser;
    stabiliser.set({.distance = 12.0, .delay = 0.0});
    stabiliser.begin(sampleAt(0.0, 0.0, 0.0));
    double greatest = 0.0;
    PointerSample drawn;
    for (int i = 1; i <= 400; ++i) {
        drawn = stabiliser.move(sampleAt(i, i % 2 == 0 ? 4.0 : -4.0, 0.01 * i));
        greatest = std::max(greatest, std::abs(drawn.position.y()));
    }
    QVERIFY(greatest < 0.8);
    QVERIFY(std::abs(drawn.position.x() - 388.0) < 1.0);
}

void StrokeStabiliserTest::delay_comesLaterAndComes()
{
    StrokeStabiliser stabiliser;
    stabiliser.set({.distance = 0.0, .delay = 0.2});
    stabiliser.begin(sampleAt(0.0, 0.0, 0.0));
    // The way that is left does not depend on the number of samples.
    PointerSample drawn = stabiliser.move(sampleAt(100.0, 0.0, 0.1));
    QVERIFY(std::abs(drawn.position.x() - 100.0 * (1.0 - std::exp(-0.5))) < 1e-9);
    drawn = *stabiliser.rest(0.15);
    drawn = *stabiliser.rest(0.2);
    QVERIFY(std::abs(drawn.position.x() - 100.0 * (1.0 - std::exp(-1.0))) < 1e-9);
    QCOMPARE(drawn.time, 0.2);
    int rests = 0;
    for (double time = 0.22; stabiliser.rest(time); time += 0.02)
        ++rests;
    QVERIFY(rests > 20 && rests < 100);
}

const TestClass<StrokeStabiliserTest> strokeStabiliserTest;

} // namespace espalier::test

#include "StrokeStabiliserTest.moc"

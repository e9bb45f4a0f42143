// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/FramePacer.h"

#include "tests/support/TestClasses.h"

#include <QTest>

using namespace espalier;

namespace {

constexpr double kSlow = 2.0 * FramePacer::kFrameBudget;

RenderOptions applied(const FramePacer& pacer)
{
    RenderOptions options;
    pacer.apply(options);
    return options;
}

/// Reports enough slow frames for one more step of saving.
void drag(FramePacer& pacer)
{
    const FramePacer::Saving before = pacer.saving();
    for (int i = 0; i < 10 && pacer.saving() == before; ++i)
        pacer.frameTook(kSlow);
}

} // namespace

class FramePacerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void atRest_isAtItsBest();
    void moving_savesOnlyTheSamplesWhereFramesAreFast();
    void slowFrames_saveStepByStep();
    void oneSlowFrame_isForgiven();
    void earlierShadows_areMadeAnewNowAndThen();
    void nextMovement_startsBetter();
};

void FramePacerTest::atRest_isAtItsBest()
{
    const FramePacer pacer;
    QVERIFY(pacer.isAtRest());
    QCOMPARE(applied(pacer).samples, RenderOptions::kBestSamples);
    QVERIFY(!applied(pacer).keepsShadows);
    QCOMPARE(pacer.scale(), 1.0);
}

void FramePacerTest::moving_savesOnlyTheSamplesWhereFramesAreFast()
{
    FramePacer pacer;
    pacer.disturb();
    for (int i = 0; i < 100; ++i)
        pacer.frameTook(0.1 * FramePacer::kFrameBudget);
    QVERIFY(!pacer.isAtRest());
    QCOMPARE(applied(pacer).samples, 1);
    QVERIFY(!applied(pacer).keepsShadows && !applied(pacer).isPlain);
    QCOMPARE(pacer.scale(), 1.0);
}

void FramePacerTest::slowFrames_saveStepByStep()
{
    FramePacer pacer;
    pacer.disturb();
    drag(pacer);
    QCOMPARE(pacer.saving(), FramePacer::Saving::EarlierShadows);
    QVERIFY(!applied(pacer).isPlain);
    drag(pacer);
    QCOMPARE(pacer.saving(), FramePacer::Saving::PlainLight);
    QVERIFY(applied(pacer).isPlain);
    QCOMPARE(pacer.scale(), 1.0);
    drag(pacer);
    QVERIFY(pacer.scale() < 1.0);
    drag(pacer);
    QCOMPARE(pacer.scale(), 0.5);
    drag(pacer);
    QCOMPARE(pacer.saving(), FramePacer::Saving::MostPixels);
}

void FramePacerTest::oneSlowFrame_isForgiven()
{
    FramePacer pacer;
    pacer.disturb();
    for (int i = 0; i < 20; ++i) {
        pacer.frameTook(kSlow);
        pacer.frameTook(0.0);
    }
    QCOMPARE(pacer.saving(), FramePacer::Saving::Nothing);
}

void FramePacerTest::earlierShadows_areMadeAnewNowAndThen()
{
    FramePacer pacer;
    pacer.disturb();
    drag(pacer);
    int anew = 0;
    for (int i = 0; i < 5 * FramePacer::kShadowFrames; ++i) {
        anew += applied(pacer).keepsShadows ? 0 : 1;
        pacer.frameTook(0.0);
    }
    QCOMPARE(anew, 5);
    pacer.rest();
    QVERIFY(pacer.isAtRest());
    QVERIFY(!applied(pacer).keepsShadows);
}

void FramePacerTest::nextMovement_startsBetter()
{
    FramePacer pacer;
    pacer.disturb();
    drag(pacer);
    drag(pacer);
    pacer.rest();
    pacer.disturb();
    QCOMPARE(pacer.saving(), FramePacer::Saving::EarlierShadows);
    QVERIFY(!applied(pacer).isPlain);
}

static const test::TestClass<FramePacerTest> framePacerTest;

#include "FramePacerTest.moc"

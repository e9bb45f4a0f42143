// SPDX-License-Identifier: GPL-3.0-or-later
// Trees grown in lassos drawn by untrained people. Six drawings that imitate such people; with a folder of
// real drawings in the environment variable ESPALIER_SKETCHES, all of those too.
#include "commands/EnvelopeGrowth.h"
#include "commands/LassoGesture.h"
#include "model/envelope/LassoLoop.h"
#include "tests/support/CrownSilhouette.h"
#include "tests/support/Sketches.h"
#include "tests/support/TestClasses.h"

#include <QElapsedTimer>
#include <QTest>

namespace espalier::test {

namespace {

/// A drawing as a lasso in m: 5 m along its longer side, its lowest point 0.8 m above the seedling.
std::vector<Vec2> placed(const std::vector<Vec2>& drawn)
{
    Eigen::AlignedBox2f box;
    for (const Vec2& point : drawn)
        box.extend(point);
    const float scale = 5.0F / box.sizes().maxCoeff();
    std::vector<Vec2> points;
    for (const Vec2& point : drawn) // y points down on paper
        points.emplace_back(scale * (point.x() - box.center().x()),
                            0.8F + scale * (box.max().y() - point.y()));
    return points;
}

} // namespace

class LassoSketchesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void crown_fillsTheSilhouetteAndKeepsToIt_data();
    void crown_fillsTheSilhouetteAndKeepsToIt();
};

void LassoSketchesTest::crown_fillsTheSilhouetteAndKeepsToIt_data()
{
    QTest::addColumn<std::vector<Vec2>>("points");
    std::vector<Sketch> sketches = drawnCrowns();
    for (const char* kind : {"tree", "cloud"}) {
        for (Sketch& sketch : givenSketches(QString::fromLatin1(kind))) {
            if (isClosed(sketch.points, 0.05F))
                sketches.push_back(std::move(sketch));
        }
    }
    for (const Sketch& sketch : sketches)
        QTest::newRow(qPrintable(sketch.name)) << placed(sketch.points);
}

void LassoSketchesTest::crown_fillsTheSilhouetteAndKeepsToIt()
{
    QFETCH(const std::vector<Vec2>, points);
    TreeDocument document;
    LassoStroke stroke;
    stroke.points = points;
    QElapsedTimer clock;
    clock.start();
    LassoGesture::Begun begun = LassoGesture::fill(document, stroke);
    QVERIFY2(begun, begun ? "" : qPrintable(begun.error().message));
    int steps = 0;
    while ((*begun)->step())
        ++steps;
    QVERIFY(steps < EnvelopeGrowth::kMostSteps);
    const Envelope envelope = EnvelopeSet::fromStrokes(document.tree().lassosInForce())->envelopes().front();
    (*begun)->finish();
    const auto [covered, outside] = crownSilhouette(document, envelope);
    qInfo("%.1f %% covered, %.1f %% outside, %d steps, %u internodes, %lld ms", 100.0 * covered,
          100.0 * outside, steps, document.index().livingCount(), clock.elapsed());
    QVERIFY(covered >= 0.8);
    QVERIFY(outside <= 0.03);
}

static const TestClass<LassoSketchesTest> lassoSketchesTest;

} // namespace espalier::test

#include "LassoSketchesTest.moc"

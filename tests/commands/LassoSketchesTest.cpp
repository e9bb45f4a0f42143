// SPDX-License-Identifier: GPL-3.0-or-later
// Trees grown in lassos that untrained hands drew. Six sketches by default; all of them with
// ESPALIER_ALL_SKETCHES=1 in the environment. Skipped where the sketches are not at hand.
#include "commands/EnvelopeGrowth.h"
#include "commands/LassoGesture.h"
#include "model/envelope/LassoLoop.h"
#include "tests/support/CrownSilhouette.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

namespace espalier::test {

namespace {

/// The largest stroke of a sketch, m: 5 m along its longer side, its lowest point 0.8 m above the seedling.
struct Sketch {
    QString name;
    std::vector<Vec2> points;
};

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

/// Those whose largest stroke is closed up to a fifth of its size.
std::vector<Sketch> closedSketches()
{
    std::vector<Sketch> sketches;
    for (const char* kind : {"tree", "cloud"}) {
        QFile file(QStringLiteral(SOURCE_DIR "/../shared/sketches/%1.ndjson").arg(kind));
        if (!file.open(QIODevice::ReadOnly))
            continue;
        for (int line = 1; !file.atEnd(); ++line) {
            const QJsonArray strokes =
                QJsonDocument::fromJson(file.readLine()).object().value(QStringLiteral("drawing")).toArray();
            std::vector<Vec2> largest;
            float size = 0.0F;
            for (const QJsonValue& stroke : strokes) {
                const QJsonArray x = stroke.toArray().at(0).toArray();
                const QJsonArray y = stroke.toArray().at(1).toArray();
                std::vector<Vec2> points;
                Eigen::AlignedBox2f box;
                for (qsizetype i = 0; i < x.size(); ++i) {
                    points.emplace_back(static_cast<float>(x.at(i).toDouble()),
                                        static_cast<float>(y.at(i).toDouble()));
                    box.extend(points.back());
                }
                if (box.sizes().prod() > size) {
                    size = box.sizes().prod();
                    largest = std::move(points);
                }
            }
            if (largest.size() < 3 || (largest.front() - largest.back()).norm() > 0.2F * std::sqrt(size))
                continue;
            sketches.push_back({QStringLiteral("%1 %2").arg(kind).arg(line), placed(largest)});
        }
    }
    return sketches;
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
    const std::vector<Sketch> sketches = closedSketches();
    if (sketches.empty())
        QSKIP("The sketches are not here.");
    const bool all = qEnvironmentVariableIntValue("ESPALIER_ALL_SKETCHES") != 0;
    const std::size_t stride = all ? 1 : std::max<std::size_t>(1, sketches.size() / 6);
    for (std::size_t i = 0; i < (all ? sketches.size() : 6 * stride) && i < sketches.size(); i += stride)
        QTest::newRow(qPrintable(sketches[i].name)) << sketches[i].points;
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

} // namespace espalier::test

QTEST_GUILESS_MAIN(espalier::test::LassoSketchesTest)
#include "LassoSketchesTest.moc"

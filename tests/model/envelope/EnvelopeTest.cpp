// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/EnvelopeSet.h"
#include "tests/model/envelope/Silhouettes.h"
#include "tests/support/Sketches.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <tbb/global_control.h>

#include <array>
#include <limits>

namespace espalier::test {

class EnvelopeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void disc_becomesABall();
    void bar_becomesARoundBar();
    void silhouette_isKept_data();
    void silhouette_isKept();
    void silhouette_drawnByHand_isKept_data();
    void silhouette_drawnByHand_isKept();
    void surface_isAtLeastAsHighAsTheOutlineIsFar();
    void surface_isZeroOnTheOutline();
    void envelope_isSymmetricAboutItsPlane();
    void bounds_areThoseOfWhatIsInside();
    void size_scalesTheVolume();
    void markers_lieInside();
    void markers_areUniform();
    void markers_areTheSameOnOneThreadOrMany();
    void innerStroke_isAHole();
    void strokesBesideOneAnother_areUnited();
    void doubleLoop_hasNoHole();
    void figureEight_hasBothLobes();
    void spiral_isFilled();
    void overshootingEnds_leaveNoTails();
    void strokesThatEncloseNothing_areRefused_data();
    void strokesThatEncloseNothing_areRefused();
    void nonsenseAmongPoints_changesNothing();
    void planesThatAreNone_areRefused();
    void manyPoints_areBearable();
    void resolution_changesTheVolumeLittle();
    void set_containsWhatAnyContains();
    void set_ofSeveralPlanes_isFilledUniformly();
    void set_joinsStrokesInOnePlane();
    void set_leavesOutStrokesThatEncloseNothing();
};

namespace {

LassoStroke strokeOf(Points points)
{
    return {.points = std::move(points)};
}

Envelope envelopeOf(const std::vector<LassoStroke>& strokes, const EnvelopeOptions& options = {})
{
    Result<Envelope> envelope = Envelope::fromStrokes(strokes, options);
    if (!envelope)
        qFatal("%s", qPrintable(envelope.error().message));
    return *envelope;
}

Envelope envelopeOf(const Points& points)
{
    return envelopeOf({strokeOf(points)});
}

bool containsAt(const Envelope& envelope, double x, double y, double z = 0.0)
{
    return envelope.contains(Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
}

double ballVolume(double radius)
{
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

/// χ² of counts against what was expected.
double chiSquared(const std::vector<double>& counts, const std::vector<double>& expected)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    return sum;
}

std::vector<std::pair<QString, Points>> shapes()
{
    return {{"circle", circle(3.0)},
            {"heart", heart()},
            {"arch", arch()},
            {"swan", swan()},
            {"letter A", letterA()},
            {"letter E", letterE()},
            {"letter S", letterS()},
            {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
            {"sliver", {{0, 0}, {20, 0}, {20, 1}, {0, 1}}},
            {"triangle", {{0, 0}, {4, 0}, {0, 3}}}};
}

} // namespace

void EnvelopeTest::disc_becomesABall()
{
    const Envelope ball = envelopeOf(circle(2.5, 1.0, -3.0));
    const double volume = ball.volume() / ballVolume(2.5);
    qInfo("volume of a ball: %.4f of what it should be", volume);
    QVERIFY(std::abs(volume - 1.0) < 0.01);
    for (const double share : {0.0, 0.3, 0.6, 0.9}) {
        const double height = 2.5 * std::sqrt(1.0 - share * share);
        for (const double angle : {0.1, 1.3, 2.9, 4.4}) {
            const double x = 1.0 + 2.5 * share * std::cos(angle);
            const double y = -3.0 + 2.5 * share * std::sin(angle);
            QVERIFY(containsAt(ball, x, y, 0.97 * height));
            QVERIFY(!containsAt(ball, x, y, 1.03 * height));
        }
    }
}

void EnvelopeTest::bar_becomesARoundBar()
{
    const Envelope bar = envelopeOf(Points{{0, 0}, {10, 0}, {10, 1}, {0, 1}});
    for (const double across : {0.1, 0.3, 0.5, 0.8}) {
        const double height = std::sqrt(0.25 - (across - 0.5) * (across - 0.5));
        QVERIFY(containsAt(bar, 4.3, across, 0.92 * height));
        QVERIFY(!containsAt(bar, 4.3, across, 1.05 * height));
    }
}

void EnvelopeTest::silhouette_isKept_data()
{
    QTest::addColumn<int>("shape");
    for (std::size_t i = 0; i < shapes().size(); ++i)
        QTest::newRow(qPrintable(shapes()[i].first)) << static_cast<int>(i);
}

void EnvelopeTest::silhouette_isKept()
{
    QFETCH(const int, shape);
    const Points points = shapes()[static_cast<std::size_t>(shape)].second;
    const Envelope envelope = envelopeOf(points);
    const double kept = overlap(
        points, 250, [&](double x, double y) { return containsAt(envelope, x, y); },
        [&](double x, double y) { return encloses(points, x, y); });
    qInfo("intersection over union: %.4f", kept);
    QVERIFY(kept >= 0.98);
}

void EnvelopeTest::silhouette_drawnByHand_isKept_data()
{
    QTest::addColumn<Points>("points");
    std::vector<Sketch> sketches = drawnCrowns();
    for (const char* kind : {"tree", "cloud"}) {
        for (Sketch& sketch : givenSketches(QString::fromLatin1(kind))) {
            if (isClosed(sketch.points, 0.1F))
                sketches.push_back(std::move(sketch));
        }
    }
    for (const Sketch& sketch : sketches)
        QTest::newRow(qPrintable(sketch.name)) << sketch.points;
}

void EnvelopeTest::silhouette_drawnByHand_isKept()
{
    QFETCH(const Points, points);
    const Envelope envelope = envelopeOf(points);
    const double kept = overlap(
        points, 200, [&](double x, double y) { return containsAt(envelope, x, y); },
        [&](double x, double y) { return encloses(points, x, y); });
    qInfo("intersection over union: %.4f", kept);
    QVERIFY2(kept >= 0.97, qPrintable(QString::number(kept)));
}

void EnvelopeTest::surface_isAtLeastAsHighAsTheOutlineIsFar()
{
    for (const auto& [name, points] : shapes()) {
        const EnvelopeField field = envelopeOf(points).field();
        for (std::size_t i = 0; i < field.distance.size(); ++i) {
            if (field.distance[i] > 0.0F)
                QVERIFY(field.squaredHeight[i] >= field.distance[i] * field.distance[i]);
            else
                QVERIFY(field.squaredHeight[i] <= 0.0F);
        }
    }
}

void EnvelopeTest::surface_isZeroOnTheOutline()
{
    for (const auto& [name, points] : shapes()) {
        const EnvelopeField field = envelopeOf(points).field();
        double highest = 0.0;
        double radius = 0.0;
        for (std::size_t i = 0; i < field.distance.size(); ++i)
            radius = std::max(radius, double{field.distance[i]});
        for (const Loop& loop : field.outlines) {
            for (const Eigen::Vector2d& point : loop) {
                const int x = static_cast<int>(point.x());
                const int y = static_cast<int>(point.y());
                highest = std::max(highest, field.squaredHeightAt({x, y, point.x() - x, point.y() - y}));
            }
        }
        // A ball of that radius rises to √(2 R d) at d from its rim.
        const double off = highest / (2.0 * radius);
        QVERIFY2(off < 1.0, qPrintable(QString("%1: %2").arg(name).arg(off)));
    }
}

void EnvelopeTest::envelope_isSymmetricAboutItsPlane()
{
    const Envelope envelope = envelopeOf(heart());
    Random random(5, 0, 0, Purpose::Texture);
    const Box3 box = envelope.bounds();
    int inside = 0;
    for (int i = 0; i < 5000; ++i) {
        const double x = random.uniform(double{box.min().x()}, double{box.max().x()});
        const double y = random.uniform(double{box.min().y()}, double{box.max().y()});
        const double z = random.uniform(0.0, double{box.max().z()});
        QCOMPARE(containsAt(envelope, x, y, z), containsAt(envelope, x, y, -z));
        if (containsAt(envelope, x, y, z)) {
            QVERIFY(containsAt(envelope, x, y, 0.5 * z));
            ++inside;
        }
    }
    QVERIFY(inside > 500);
}

void EnvelopeTest::bounds_areThoseOfWhatIsInside()
{
    LassoStroke stroke = strokeOf(circle(3.0));
    stroke.origin = {10, 20, 30};
    stroke.right = Vec3(1, 0, -1).normalized();
    const Envelope envelope = envelopeOf({stroke});
    Box3 found;
    for (const Vec3& marker : envelope.sampleUniform(50000, 1)) {
        QVERIFY(envelope.bounds().contains(marker));
        found.extend(marker);
    }
    const double slack = double{(envelope.bounds().sizes() - found.sizes()).maxCoeff()};
    QVERIFY2(slack < 0.12, qPrintable(QString::number(slack)));
    for (const std::vector<Vec3>& line : envelope.outline())
        for (const Vec3& point : line)
            QVERIFY(envelope.bounds().contains(point));
}

void EnvelopeTest::size_scalesTheVolume()
{
    const double unit = envelopeOf(heart()).volume();
    for (const double scale : {1e-3 / 32.0, 1e3 / 32.0}) {
        Points points = heart();
        for (Vec2& point : points)
            point *= static_cast<float>(scale);
        const Envelope envelope = envelopeOf(points);
        QVERIFY(std::abs(envelope.volume() / (unit * std::pow(scale, 3)) - 1.0) < 1e-3);
        for (const Vec3& marker : envelope.sampleUniform(100, 1))
            QVERIFY(envelope.contains(marker));
    }
}

void EnvelopeTest::markers_lieInside()
{
    for (const auto& [name, points] : shapes()) {
        LassoStroke stroke = strokeOf(points);
        stroke.origin = {100, 0, -40};
        stroke.right = Vec3(2, 1, -1).normalized();
        stroke.up = stroke.right.cross(Vec3(1, 5, 1)).normalized();
        const Envelope envelope = envelopeOf({stroke});
        const std::vector<Vec3> markers = envelope.sampleUniform(2000, 3);
        QCOMPARE(markers.size(), std::size_t{2000});
        for (const Vec3& marker : markers)
            QVERIFY(envelope.contains(marker));
    }
    QVERIFY(envelopeOf(heart()).sampleUniform(0, 1).empty());
}

void EnvelopeTest::markers_areUniform()
{
    const Envelope ball = envelopeOf(circle(1.0));
    const std::vector<Vec3> markers = ball.sampleUniform(40000, 11);
    std::vector<double> octants(8, 0.0);
    std::vector<double> shells(5, 0.0);
    for (const Vec3& marker : markers) {
        const unsigned octant =
            (marker.x() > 0.0F ? 1U : 0U) | (marker.y() > 0.0F ? 2U : 0U) | (marker.z() > 0.0F ? 4U : 0U);
        octants[octant] += 1.0;
        const double share = std::pow(double{marker.norm()}, 3);
        shells[static_cast<std::size_t>(std::clamp(share * 5.0, 0.0, 4.0))] += 1.0;
    }
    const double inOctants = chiSquared(octants, std::vector<double>(8, 5000.0));
    const double inShells = chiSquared(shells, std::vector<double>(5, 8000.0));
    qInfo("chi-squared of octants %.1f, of shells of equal volume %.1f", inOctants, inShells);
    QVERIFY(inOctants < 24.3); // one in a thousand, 7 degrees of freedom
    QVERIFY(inShells <
            30.0); // 18.5 for 4 degrees, and the ball's radius is right to a fifth of a percent only

    // Another seed and another step give other markers.
    QVERIFY(ball.sampleUniform(10, 1) != ball.sampleUniform(10, 2));
    QVERIFY(ball.sampleUniform(10, 1, 0) != ball.sampleUniform(10, 1, 1));
}

void EnvelopeTest::markers_areTheSameOnOneThreadOrMany()
{
    const EnvelopeSet set({envelopeOf(heart()), envelopeOf(circle(9.0, 4.0, 2.0))});
    const std::vector<Vec3> many = set.sampleUniform(20000, 5, 6);
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    const EnvelopeSet again({envelopeOf(heart()), envelopeOf(circle(9.0, 4.0, 2.0))});
    QVERIFY(again.sampleUniform(20000, 5, 6) == many);
    // More markers do not change the first ones.
    const std::vector<Vec3> few = set.sampleUniform(100, 5, 6);
    QVERIFY(std::equal(few.begin(), few.end(), many.begin()));
}

void EnvelopeTest::innerStroke_isAHole()
{
    const std::vector<Points> rings{circle(1.0), circle(3.0), circle(2.0)};
    const Envelope one = envelopeOf({strokeOf(rings[1]), strokeOf(rings[2])});
    QVERIFY(containsAt(one, 2.5, 0.0));
    QVERIFY(!containsAt(one, 1.5, 0.0));
    QVERIFY(!containsAt(one, 0.0, 0.0));
    QCOMPARE(one.outline().size(), std::size_t{2});
    QVERIFY(std::abs(one.volume() / (2.0 * std::numbers::pi * std::numbers::pi * 2.5 * 0.25) - 1.0) < 0.02);
    // An island in the hole, in any order of the strokes.
    const Envelope two = envelopeOf({strokeOf(rings[0]), strokeOf(rings[1]), strokeOf(rings[2])});
    QVERIFY(containsAt(two, 2.5, 0.0));
    QVERIFY(!containsAt(two, 1.5, 0.0));
    QVERIFY(containsAt(two, 0.0, 0.0));
    // A hole in the common part of two strokes is a hole in their union.
    const Envelope three =
        envelopeOf({strokeOf(circle(3.0)), strokeOf(circle(3.0, 1.0)), strokeOf(circle(0.5, 0.5))});
    QVERIFY(!containsAt(three, 0.5, 0.0));
    QVERIFY(containsAt(three, 1.5, 0.0));
}

void EnvelopeTest::strokesBesideOneAnother_areUnited()
{
    const Envelope apart = envelopeOf({strokeOf(circle(1.0)), strokeOf(circle(1.0, 4.0))});
    QVERIFY(containsAt(apart, 0.0, 0.0) && containsAt(apart, 4.0, 0.0) && !containsAt(apart, 2.0, 0.0));
    QVERIFY(std::abs(apart.volume() / (2.0 * ballVolume(1.0)) - 1.0) < 0.03);
    const Envelope overlapping = envelopeOf({strokeOf(circle(1.0)), strokeOf(circle(1.0, 1.0))});
    QVERIFY(containsAt(overlapping, 0.5, 0.0));
    QCOMPARE(overlapping.outline().size(), std::size_t{1});
    // The same stroke twice is no hole.
    const Envelope twice = envelopeOf({strokeOf(circle(1.0)), strokeOf(circle(1.0))});
    QVERIFY(containsAt(twice, 0.0, 0.0));
}

void EnvelopeTest::doubleLoop_hasNoHole()
{
    const Envelope envelope = envelopeOf(curve(300, [](double t) {
        const double angle = 4.0 * std::numbers::pi * t;
        const double radius = 2.0 + std::cos(0.5 * angle);
        return std::pair(radius * std::cos(angle), radius * std::sin(angle));
    }));
    for (double x = -1.5; x < 2.0; x += 0.25)
        QVERIFY(containsAt(envelope, x, 0.0));
}

void EnvelopeTest::figureEight_hasBothLobes()
{
    const Envelope envelope = envelopeOf(curve(200, [](double t) {
        const double a = 2.0 * std::numbers::pi * t;
        return std::pair(std::sin(a), std::sin(2.0 * a));
    }));
    QVERIFY(containsAt(envelope, 0.6, 0.0, 0.3) && containsAt(envelope, -0.6, 0.0, 0.3));
    QVERIFY(!containsAt(envelope, 0.0, 0.4));
    QVERIFY(containsAt(envelope, 0.7, 0.8) && containsAt(envelope, -0.7, -0.8));
}

void EnvelopeTest::spiral_isFilled()
{
    Points points;
    for (int i = 0; i <= 2000; ++i) {
        const double angle = 0.02 * i;
        points.emplace_back(static_cast<float>(0.05 * angle * std::cos(angle)),
                            static_cast<float>(0.05 * angle * std::sin(angle)));
    }
    const Envelope envelope = envelopeOf(points);
    QVERIFY(envelope.volume() > 0.5 * ballVolume(1.7));
    QVERIFY(envelope.volume() < ballVolume(2.0));
    QVERIFY(containsAt(envelope, 0.5, 0.5) && containsAt(envelope, -0.7, 0.2));
}

void EnvelopeTest::overshootingEnds_leaveNoTails()
{
    Points points{{2.0F, 0.3F}};
    const Points round = circle(2.0);
    points.insert(points.end(), round.begin() + 4, round.end());
    points.front() = {3.0F, 0.25F}; // comes from outside, and leaves outward below
    points.insert(points.end(), {{1.97F, 0.35F}, {2.5F, 0.7F}});
    const Envelope envelope = envelopeOf(points);
    QVERIFY(envelope.bounds().max().x() < 2.1F);
    QVERIFY(containsAt(envelope, 1.8, 0.0) && containsAt(envelope, 0.0, 1.9));
}

void EnvelopeTest::strokesThatEncloseNothing_areRefused_data()
{
    QTest::addColumn<QList<QPointF>>("points");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("no point") << QList<QPointF>{};
    QTest::newRow("one point") << QList<QPointF>{{1, 2}};
    QTest::newRow("two points") << QList<QPointF>{{1, 2}, {3, 4}};
    QTest::newRow("collinear") << QList<QPointF>{{0, 0}, {1, 1}, {3, 3}, {2, 2}};
    QTest::newRow("collinear along an axis") << QList<QPointF>{{0, 0}, {1, 0}, {3, 0}, {2, 0}};
    QTest::newRow("all equal") << QList<QPointF>(50, QPointF(1, 1));
    QTest::newRow("not numbers") << QList<QPointF>{{nan, 0}, {0, nan}, {nan, nan}, {1, 0}, {1, 1}};
    QTest::newRow("a scratch") << QList<QPointF>{{0, 0}, {1, 0}, {1, 1e-4}, {0, 1e-4}};
    QTest::newRow("nothing to see") << QList<QPointF>{{0, 0}, {1e-9, 0}, {1e-9, 1e-9}, {0, 1e-9}};
    QTest::newRow("far away") << QList<QPointF>{{1e30, 0}, {1e31, 0}, {0, 1e31}, {-1e30, -1e30}};
}

void EnvelopeTest::strokesThatEncloseNothing_areRefused()
{
    QFETCH(const QList<QPointF>, points);
    LassoStroke stroke;
    for (const QPointF& point : points)
        stroke.points.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
    const Result<Envelope> envelope = Envelope::fromStrokes(std::vector{stroke});
    QVERIFY(!envelope);
    QVERIFY(envelope.error().message.endsWith(QLatin1Char('.')));
    QVERIFY(!EnvelopeSet::fromStrokes(std::vector{stroke}));
}

void EnvelopeTest::nonsenseAmongPoints_changesNothing()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Points points = heart();
    const double volume = envelopeOf(points).volume();
    points.insert(points.begin() + 20, Vec2(nan, 1.0F));
    points.insert(points.begin() + 70, Vec2(1.0F, std::numeric_limits<float>::infinity()));
    points.insert(points.begin() + 90, points[90]);
    QCOMPARE(envelopeOf(points).volume(), volume);
    // Neither does a stroke that encloses nothing.
    QCOMPARE(envelopeOf({strokeOf({{1, 1}}), strokeOf(points)}).volume(), volume);
}

void EnvelopeTest::planesThatAreNone_areRefused()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::array<LassoStroke, 5> strokes;
    strokes.fill(strokeOf(heart()));
    strokes[0].origin.x() = nan;
    strokes[1].right = Vec3::Zero();
    strokes[2].up = strokes[2].right;
    strokes[3].up = Vec3(nan, nan, nan);
    strokes[4].origin = Vec3(1e9F, 0.0F, 0.0F); // 32 m, where numbers are 64 m apart
    for (const LassoStroke& stroke : strokes) {
        QVERIFY(!Envelope::fromStrokes(std::vector{stroke}));
        QVERIFY(!EnvelopeSet::fromStrokes(std::vector{stroke}));
    }
    QVERIFY(!Envelope::fromStrokes({}));
}

void EnvelopeTest::manyPoints_areBearable()
{
    Random random(2, 0, 0, Purpose::Texture);
    Points shaky = circle(2.0, 0.0, 0.0, 100000);
    for (Vec2& point : shaky)
        point +=
            Vec2(static_cast<float>(0.005 * random.normal()), static_cast<float>(0.005 * random.normal()));
    QVERIFY(std::abs(envelopeOf(shaky).volume() / ballVolume(2.0) - 1.0) < 0.03);
    Points scribble;
    for (int i = 0; i < 100000; ++i)
        scribble.emplace_back(static_cast<float>(random.uniform()), static_cast<float>(random.uniform()));
    const Result<Envelope> scribbled = Envelope::fromStrokes(std::vector{strokeOf(scribble)});
    QVERIFY(scribbled);
    for (const Vec3& marker : scribbled->sampleUniform(1000, 1))
        QVERIFY(scribbled->contains(marker));
}

void EnvelopeTest::resolution_changesTheVolumeLittle()
{
    for (const Points& points : {heart(), swan(), letterE()}) {
        const double fine = envelopeOf({strokeOf(points)}, {.resolution = 512}).volume();
        QVERIFY(std::abs(envelopeOf({strokeOf(points)}, {.resolution = 256}).volume() / fine - 1.0) < 0.02);
        QVERIFY(std::abs(envelopeOf({strokeOf(points)}, {.resolution = 128}).volume() / fine - 1.0) < 0.05);
    }
}

void EnvelopeTest::set_containsWhatAnyContains()
{
    LassoStroke side = strokeOf(circle(1.0, -2.0));
    side.right = Vec3(0, 0, -1);
    const Result<EnvelopeSet> set = EnvelopeSet::fromStrokes(std::vector{strokeOf(circle(1.0)), side});
    QVERIFY(set);
    QCOMPARE(set->envelopes().size(), std::size_t{2});
    QVERIFY(set->contains({0, 0, 0}) && set->contains({0, 0, 2}) && !set->contains({2, 0, 0}));
    QVERIFY(set->bounds().contains(Vec3(0, 0, 2.9F)) && set->bounds().contains(Vec3(0.9F, 0, 0)));
    QVERIFY(EnvelopeSet().isEmpty() && !EnvelopeSet().contains({0, 0, 0}));
    QVERIFY(EnvelopeSet().sampleUniform(10, 1).empty() && EnvelopeSet().bounds().isEmpty());
    QCOMPARE(EnvelopeSet().volume(), 0.0);
}

void EnvelopeTest::set_ofSeveralPlanes_isFilledUniformly()
{
    // Two balls of radius 1 whose centres are 1 apart along x, drawn from two sides.
    LassoStroke side = strokeOf(circle(1.0));
    side.origin = {1, 0, 0};
    side.right = Vec3(0, 0, -1);
    const Result<EnvelopeSet> set = EnvelopeSet::fromStrokes(std::vector{strokeOf(circle(1.0)), side});
    QVERIFY(set);
    const double lens = std::numbers::pi * 5.0 / 12.0;
    const double whole = 2.0 * ballVolume(1.0) - lens;
    QVERIFY(std::abs(set->volume() / whole - 1.0) < 0.02);

    constexpr double kCount = 40000.0;
    std::vector<double> counts(3, 0.0);
    for (const Vec3& marker : set->sampleUniform(static_cast<std::size_t>(kCount), 4)) {
        QVERIFY(set->contains(marker));
        const bool first = set->envelopes()[0].contains(marker);
        const bool second = set->envelopes()[1].contains(marker);
        counts[first && second ? 2 : first ? 0 : 1] += 1.0;
    }
    const double alone = kCount * (ballVolume(1.0) - lens) / whole;
    const double chi = chiSquared(counts, {alone, alone, kCount * lens / whole});
    qInfo("chi-squared of two balls and what they share: %.1f", chi);
    QVERIFY(chi < 13.8); // one in a thousand, 2 degrees of freedom
}

void EnvelopeTest::set_joinsStrokesInOnePlane()
{
    // The hole was drawn with another origin and turned axes in the same plane.
    LassoStroke hole = strokeOf(circle(1.0));
    hole.origin = {1, 1, 0};
    hole.right = Vec3(0, 1, 0);
    hole.up = Vec3(-1, 0, 0);
    const Result<EnvelopeSet> set = EnvelopeSet::fromStrokes(std::vector{strokeOf(circle(4.0)), hole});
    QVERIFY(set);
    QCOMPARE(set->envelopes().size(), std::size_t{1});
    QVERIFY(!set->contains({1, 1, 0}) && set->contains({-1, -1, 0}));
}

void EnvelopeTest::set_leavesOutStrokesThatEncloseNothing()
{
    LassoStroke side = strokeOf({{0, 0}, {1, 1}});
    side.right = Vec3(0, 0, -1);
    const Result<EnvelopeSet> set = EnvelopeSet::fromStrokes(std::vector{side, strokeOf(circle(1.0))});
    QVERIFY(set);
    QCOMPARE(set->envelopes().size(), std::size_t{1});
}

const TestClass<EnvelopeTest> envelopeTest;

} // namespace espalier::test

#include "EnvelopeTest.moc"

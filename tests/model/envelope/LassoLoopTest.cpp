// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/LassoLoop.h"

#include "model/base/Random.h"
#include "tests/model/envelope/Silhouettes.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <limits>

namespace espalier::test {

class LassoLoopTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void simplified_staysWithinItsTolerance();
    void simplified_keepsEndsAndCorners();
    void simplified_ofManyPointsIsBounded();
    void simplified_leavesOutNonsense();
    void simplified_again_changesLittle();
    void closedLoop_cutsTailsThatCross();
    void closedLoop_withoutCrossing_keepsAllPoints();
    void closedLoop_keepsTheLobesOfAFigureEight();
    void coplanar_knowsPlanesApart();
};

namespace {

/// The farthest that a point is from a line.
double deviation(const Points& points, const Points& line)
{
    double worst = 0.0;
    for (const Vec2& point : points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Eigen::Vector2d from = line[i].cast<double>();
            const Eigen::Vector2d along = line[i + 1].cast<double>() - from;
            const Eigen::Vector2d offset = point.cast<double>() - from;
            const double length = along.squaredNorm();
            const double place = length > 0.0 ? std::clamp(offset.dot(along) / length, 0.0, 1.0) : 0.0;
            nearest = std::min(nearest, (offset - place * along).norm());
        }
        worst = std::max(worst, nearest);
    }
    return worst;
}

double longerSide(const Points& points)
{
    Eigen::AlignedBox2d box;
    for (const Vec2& point : points)
        box.extend(point.cast<double>());
    return box.sizes().maxCoeff();
}

/// A circle drawn by a shaking hand, with as many points as a device may deliver.
Points shakyCircle(int count, double shake)
{
    Random random(1, 0, 0, Purpose::Texture);
    Points points = circle(2.0, 0.0, 0.0, count);
    for (Vec2& point : points)
        point +=
            Vec2(static_cast<float>(shake * random.normal()), static_cast<float>(shake * random.normal()));
    return points;
}

} // namespace

void LassoLoopTest::simplified_staysWithinItsTolerance()
{
    for (const Points& points :
         {circle(1.0, 0.0, 0.0, 3000), heart(), swan(), arch(), shakyCircle(2000, 0.01)}) {
        for (const double tolerance : {1.0 / 2048.0, 0.01, 0.1}) {
            const Points kept = simplified(points, tolerance);
            QVERIFY(kept.size() <= points.size());
            QVERIFY(kept.size() >= 2);
            if (points.size() <= kMostLassoPoints)
                QVERIFY(deviation(points, kept) <= 1.5 * tolerance * longerSide(points));
        }
    }
    QVERIFY(simplified(circle(1.0, 0.0, 0.0, 3000)).size() < 120);
}

void LassoLoopTest::simplified_keepsEndsAndCorners()
{
    Points points;
    for (int i = 0; i <= 100; ++i)
        points.emplace_back(0.01F * static_cast<float>(i), 0.0F);
    for (int i = 1; i <= 100; ++i)
        points.emplace_back(1.0F, 0.01F * static_cast<float>(i));
    QCOMPARE(simplified(points), (Points{{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}}));
    // There and back again along a line: the turn is kept though it lies on the line.
    const Points back{{0.0F, 0.0F}, {0.5F, 0.0F}, {1.0F, 0.0F}, {0.5F, 0.0F}, {0.2F, 0.0F}};
    QCOMPARE(simplified(back), (Points{{0.0F, 0.0F}, {1.0F, 0.0F}, {0.2F, 0.0F}}));
}

void LassoLoopTest::simplified_ofManyPointsIsBounded()
{
    for (const double shake : {0.0, 0.002, 0.1}) {
        const Points points = shakyCircle(100000, shake);
        const Points kept = simplified(points);
        QVERIFY(kept.size() <= kMostLassoPoints);
        QVERIFY(kept.size() > 50);
        Points some;
        for (std::size_t i = 0; i < points.size(); i += 500)
            some.push_back(points[i]);
        // A line with an amplitude of less than a hundredth keeps its form to about that; of a scribble the
        // outlines are kept.
        QVERIFY(deviation(some, kept) < (shake < 0.01 ? 0.05 : 0.5));
    }
}

void LassoLoopTest::simplified_leavesOutNonsense()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const Points points{{nan, 0},        {0, 0}, {0, 0}, {0, infinite}, {1, 0},
                        {1e30F, -1e30F}, {1, 1}, {1, 1}, {0, nan}};
    QCOMPARE(simplified(points), (Points{{0, 0}, {1, 0}, {1, 1}}));
    QCOMPARE(simplified({}), Points{});
    QCOMPARE(simplified({{nan, nan}}), Points{});
    QCOMPARE(simplified(Points(1000, Vec2(3, 4))), (Points{{3, 4}}));
    QCOMPARE(simplified(heart(), 0.0).size(), heart().size());
}

void LassoLoopTest::simplified_again_changesLittle()
{
    const Points once = simplified(swan());
    const Points twice = simplified(once);
    QVERIFY(deviation(swan(), twice) <= 3.0 / 2048.0 * longerSide(swan()));
}

void LassoLoopTest::closedLoop_cutsTailsThatCross()
{
    // A square whose ends cross at (0.2, 0) and go on.
    const Points points{{0.2F, -0.3F}, {0.2F, 2.0F}, {2.0F, 2.0F}, {2.0F, 0.0F}, {-0.1F, 0.0F}};
    const Points loop = closedLoop(points);
    QCOMPARE(loop.size(), std::size_t{4});
    QVERIFY((loop.front() - Vec2(0.2F, 0.0F)).norm() < 1e-6F);
    QCOMPARE(loop[1], points[1]);
    QCOMPARE(loop[3], points[3]);
    // Tails that are a large part of the stroke are not cut off.
    QCOMPARE(closedLoop(points, 0.05), points);
}

void LassoLoopTest::closedLoop_withoutCrossing_keepsAllPoints()
{
    const Points open = curve(100, [](double t) { return std::pair(std::cos(5.0 * t), std::sin(5.0 * t)); });
    QCOMPARE(closedLoop(open), open);
    QCOMPARE(closedLoop(letterE()), letterE());
}

void LassoLoopTest::closedLoop_keepsTheLobesOfAFigureEight()
{
    const Points eight = curve(101, [](double t) {
        const double a = 2.0 * std::numbers::pi * t + 1.0;
        return std::pair(std::sin(a), std::sin(2.0 * a));
    });
    QCOMPARE(closedLoop(eight), eight);
}

void LassoLoopTest::coplanar_knowsPlanesApart()
{
    const LassoStroke stroke{.origin = {1, 2, 3}, .points = {}};
    LassoStroke other = stroke;
    other.origin = {5, -7, 3};
    other.right = Vec3(0.6F, 0.8F, 0.0F);
    other.up = Vec3(-0.8F, 0.6F, 0.0F);
    QVERIFY(coplanar(stroke, other));
    other.origin.z() = 3.01F;
    QVERIFY(!coplanar(stroke, other));
    other = stroke;
    other.right = Vec3(0.0F, 0.0F, -1.0F);
    QVERIFY(!coplanar(stroke, other));
    other = stroke;
    std::swap(other.right, other.up); // seen from behind
    QVERIFY(!coplanar(stroke, other));
}

const TestClass<LassoLoopTest> lassoLoopTest;

} // namespace espalier::test

#include "LassoLoopTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/CrownHull.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class CrownHullTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void corners_ofADiamond_leaveOutInnerPoints();
    void circle_isEnlargedAroundTheMiddle();
    void contains_theDrawingAndDepthsUpToItsHalfWidth();
    void footprint_holdsAllCircles();
    void hull_ofALineOrAPoint_isThin();
};

namespace {

/// Lowest point (0, 0), top (0, 4), left (-1, 2), right (3, 2), and points inside.
const SketchLine kDiamond{{0.0, 4.0},  {3.0, 2.0}, {0.0, 1.0}, {0.5, 2.0},
                          {-1.0, 2.0}, {0.0, 0.0}, {0.0, 0.0}};

} // namespace

void CrownHullTest::corners_ofADiamond_leaveOutInnerPoints()
{
    const CrownHull hull(kDiamond);
    QCOMPARE(hull.corners(), (SketchLine{{0.0, 0.0}, {3.0, 2.0}, {0.0, 4.0}, {-1.0, 2.0}}));
    QCOMPARE(hull.bottom(), 0.0);
    QCOMPARE(hull.top(), 4.0);
}

void CrownHullTest::circle_isEnlargedAroundTheMiddle()
{
    const CrownHull hull(kDiamond);
    QVERIFY(std::abs(hull.circle(2.0).middle - 1.0) < 1e-12);
    QVERIFY(std::abs(hull.circle(2.0).radius - 2.0 * std::numbers::sqrt2) < 1e-12);
    QVERIFY(std::abs(hull.circle(1.0).middle - 0.5) < 1e-12);
    QVERIFY(std::abs(hull.circle(1.0).radius - std::numbers::sqrt2) < 1e-12);
    QCOMPARE(hull.circle(9.0).radius, 0.0);
    QVERIFY(std::abs(CrownHull(kDiamond, 3.0).circle(2.0).radius - 6.0) < 1e-12);
}

void CrownHullTest::contains_theDrawingAndDepthsUpToItsHalfWidth()
{
    Random random(1, 0, 0, Purpose::Texture);
    SketchLine points;
    for (int i = 0; i < 200; ++i)
        points.emplace_back(random.normal(), 2.0 * random.normal());
    const CrownHull hull(points);
    for (const Eigen::Vector2d& point : points) {
        // A point on the side may go back and forth by half the width: √(w² + w²) = √2 w.
        const double half = hull.circle(point.y()).radius / std::numbers::sqrt2;
        QVERIFY(hull.contains({point.x(), point.y(), 0.0}));
        QVERIFY(hull.contains({point.x(), point.y(), half}));
        QVERIFY(!hull.contains({point.x(), point.y(), 1.01 * std::numbers::sqrt2 * half + 0.01}));
    }
    QVERIFY(!hull.contains({0.0, hull.top() + 0.1, 0.0}));
    QVERIFY(!hull.contains({0.0, hull.bottom() - 0.1, 0.0}));
}

void CrownHullTest::footprint_holdsAllCircles()
{
    const CrownHull hull(kDiamond);
    Eigen::AlignedBox2d box;
    for (int i = 0; i <= 400; ++i) {
        const CrownHull::Circle circle = hull.circle(0.01 * i);
        box.extend(Eigen::Vector2d(circle.middle - circle.radius, -circle.radius));
        box.extend(Eigen::Vector2d(circle.middle + circle.radius, circle.radius));
    }
    QVERIFY(hull.footprint().isApprox(box, 1e-12));
}

void CrownHullTest::hull_ofALineOrAPoint_isThin()
{
    const CrownHull line(SketchLine{{1.0, 0.0}, {1.0, 2.0}, {1.0, 1.0}});
    QCOMPARE(line.circle(1.0).radius, 0.0);
    QCOMPARE(line.circle(1.0).middle, 1.0);
    QVERIFY(line.contains({1.0, 1.5, 0.0}));
    QVERIFY(!line.contains({1.0, 1.5, 0.1}));
    const CrownHull point(SketchLine{{1.0, 2.0}});
    QVERIFY(point.contains({1.0, 2.0, 0.0}));
    QVERIFY(!point.contains({1.1, 2.0, 0.0}));
}

const TestClass<CrownHullTest> crownHullTest;

} // namespace espalier::test

#include "CrownHullTest.moc"

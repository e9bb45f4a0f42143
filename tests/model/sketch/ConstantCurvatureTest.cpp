// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/ConstantCurvature.h"

#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace espalier::test {

class ConstantCurvatureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void curvature_isTheSameEverywhereBelowTheLimit();
    void elevation_staysBelowTheLimit();
    void arc_staysPlanar();
    void straightStroke_staysPlanar();
    void sides_mirrorEachOther();
    void endDepth_isAsAsked();
    void depths_areFiniteForAnyStroke();
};

namespace {

/// A stroke like an S: its curvature goes from 1/m to -1/m and back; points every @p step m.
SketchLine drawnWave(double step)
{
    SketchLine line{{0.0, 0.0}};
    for (double s = 0.5 * step; s < 3.0; s += step) {
        const double direction = std::sin(2.0 * s) / 2.0; // Its derivative is the curvature cos(2 s)
        line.emplace_back(line.back() + step * Eigen::Vector2d(std::cos(direction), std::sin(direction)));
    }
    return line;
}

SketchLine drawnArc(double turns, int count)
{
    SketchLine line;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2.0 * std::numbers::pi * turns * i / count;
        line.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle));
    }
    return line;
}

std::vector<Eigen::Vector3d> inSpace(const SketchLine& line, const std::vector<double>& depths)
{
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < line.size(); ++i)
        points.emplace_back(line[i].x(), line[i].y(), depths[i]);
    return points;
}

/// The elevation of each segment of a curve of space, rad.
std::vector<double> elevations(const std::vector<Eigen::Vector3d>& points)
{
    std::vector<double> result;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Eigen::Vector3d step = points[i] - points[i - 1];
        result.push_back(std::atan2(step.z(), std::hypot(step.x(), step.y())));
    }
    return result;
}

} // namespace

void ConstantCurvatureTest::curvature_isTheSameEverywhereBelowTheLimit()
{
    const SketchLine line = drawnWave(0.002);
    const ConstantCurvatureOptions options;
    const auto points = inSpace(line, constantCurvatureDepths(line, options));
    const std::vector<double> elevation = elevations(points);
    std::size_t measured = 0;
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
        const auto near = std::ranges::subrange(elevation.begin() + static_cast<std::ptrdiff_t>(i) - 2,
                                                elevation.begin() + static_cast<std::ptrdiff_t>(i) + 2);
        if (std::ranges::any_of(near, [&](double e) { return std::abs(e) > options.elevationLimit - 0.01; }))
            continue; // There the curve turns back
        const Eigen::Vector3d from = points[i] - points[i - 1];
        const Eigen::Vector3d to = points[i + 1] - points[i];
        const double turn = std::atan2(from.cross(to).norm(), from.dot(to));
        const double curvature = turn / (0.5 * (from.norm() + to.norm()));
        QVERIFY2(std::abs(curvature - 1.0) < 0.02, qPrintable(QString::number(curvature)));
        ++measured;
    }
    QVERIFY(measured > points.size() / 2);
    QVERIFY(*std::ranges::max_element(elevation) > 0.5); // The curve does leave the plane
}

void ConstantCurvatureTest::elevation_staysBelowTheLimit()
{
    const SketchLine line = drawnWave(0.01);
    for (const double limit : {0.3, 0.8, 1.2}) {
        const auto points = inSpace(line, constantCurvatureDepths(line, {.elevationLimit = limit}));
        for (const double elevation : elevations(points))
            QVERIFY(std::abs(elevation) <= limit + 1e-6);
    }
}

void ConstantCurvatureTest::arc_staysPlanar()
{
    for (const double turns : {0.1, 0.5, 1.0, -0.7}) {
        for (const double depth : constantCurvatureDepths(drawnArc(turns, 90)))
            QVERIFY(std::abs(depth) < 1e-6);
    }
}

void ConstantCurvatureTest::straightStroke_staysPlanar()
{
    SketchLine line;
    for (int i = 0; i < 20; ++i)
        line.emplace_back(0.1 * i, 0.3 * i);
    for (const double depth : constantCurvatureDepths(line))
        QCOMPARE(depth, 0.0);
}

void ConstantCurvatureTest::sides_mirrorEachOther()
{
    const SketchLine line = drawnWave(0.05);
    const auto front = constantCurvatureDepths(line, {.side = 1.0});
    const auto back = constantCurvatureDepths(line, {.side = -1.0});
    QVERIFY(front[10] > 1e-3);
    for (std::size_t i = 0; i < line.size(); ++i)
        QVERIFY(std::abs(front[i] + back[i]) < 1e-12);
}

void ConstantCurvatureTest::endDepth_isAsAsked()
{
    for (const SketchLine& line : {drawnWave(0.05), drawnArc(0.3, 10), SketchLine{{0.0, 0.0}, {1.0, 1.0}}}) {
        for (const double end : {-2.0, 0.0, 0.7}) {
            const auto depths = constantCurvatureDepths(line, {.endDepth = end});
            QCOMPARE(depths.front(), 0.0);
            QCOMPARE(depths.back(), end);
        }
    }
    const SketchLine arc = drawnArc(0.3, 10);
    const auto depths = constantCurvatureDepths(arc, {.endDepth = 2.0});
    QVERIFY(std::abs(depths[5] - 1.0) < 1e-9); // Linear in the arc length
}

void ConstantCurvatureTest::depths_areFiniteForAnyStroke()
{
    SketchLine spiral;
    for (int i = 0; i < 400; ++i) {
        const double angle = 0.1 * i;
        spiral.emplace_back(angle * std::cos(angle), angle * std::sin(angle));
    }
    const std::vector<SketchLine> lines{{},
                                        {{1.0, 1.0}},
                                        {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}},
                                        {{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}},
                                        {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}},
                                        spiral,
                                        SketchLine(spiral.rbegin(), spiral.rend())};
    for (const SketchLine& line : lines) {
        for (const double quantile : {0.0, 0.9, 1.0}) {
            const auto depths = constantCurvatureDepths(line, {.quantile = quantile});
            QCOMPARE(depths.size(), line.size());
            QVERIFY(std::ranges::all_of(depths, [](double depth) { return std::isfinite(depth); }));
        }
    }
}

const TestClass<ConstantCurvatureTest> constantCurvatureTest;

} // namespace espalier::test

#include "ConstantCurvatureTest.moc"

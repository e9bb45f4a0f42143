// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/StrokeFit.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <limits>

namespace espalier::test {

class StrokeFitTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void line_staysWithinTheToleranceOfEachSample();
    void line_hasEvenDistancesAndTheStrokesEnds();
    void shake_isFilteredAndTurnsAreKept();
    void repeatedSamples_changeNothing();
    void reversedSamples_giveTheReversedLine();
    void kind_isAsDrawn_data();
    void kind_isAsDrawn();
    void loop_isClosedWithoutRepeatingItsFirstPoint();
    void scribble_isBounded();
    void nonsense_isRefused();
};

namespace {

/// Samples of a curve of @p count points with normally distributed errors of @p shake pixels.
SketchLine drawnStroke(std::size_t count, double shake, double (*height)(double))
{
    Random random(7, 0, 0, Purpose::Texture);
    SketchLine samples;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = 300.0 * static_cast<double>(i) / static_cast<double>(count - 1);
        samples.emplace_back(x + shake * random.normal(), height(x) + shake * random.normal());
    }
    return samples;
}

double wave(double x)
{
    return 60.0 * std::sin(x / 40.0);
}

double corner(double x)
{
    return 2.0 * std::abs(x - 150.0);
}

/// The sum of a line's turns, in radians: how much it wriggles.
double turning(const SketchLine& line)
{
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const Eigen::Vector2d from = line[i] - line[i - 1];
        const Eigen::Vector2d to = line[i + 1] - line[i];
        sum += std::abs(std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to)));
    }
    return sum;
}

} // namespace

void StrokeFitTest::line_staysWithinTheToleranceOfEachSample()
{
    for (const auto height : {wave, corner}) {
        for (const double tolerance : {0.5, 2.0, 5.0}) {
            const SketchLine samples = drawnStroke(400, 0.3, height);
            const auto stroke = fitStroke(samples, {.tolerance = tolerance});
            QVERIFY(stroke);
            for (const Eigen::Vector2d& sample : samples)
                QVERIFY(nearestPlace(stroke->line, sample).distance <= 1.1 * tolerance);
        }
    }
}

void StrokeFitTest::line_hasEvenDistancesAndTheStrokesEnds()
{
    const SketchLine samples = drawnStroke(50, 0.0, wave);
    const auto stroke = fitStroke(samples);
    QVERIFY(stroke);
    QCOMPARE(stroke->line.front(), samples.front());
    QCOMPARE(stroke->line.back(), samples.back());
    const double mean = lengthOf(stroke->line) / static_cast<double>(stroke->line.size() - 1);
    QVERIFY(mean <= 6.0);
    QVERIFY(mean > 1.0);
    for (std::size_t i = 1; i < stroke->line.size(); ++i) {
        const double distance = (stroke->line[i] - stroke->line[i - 1]).norm();
        QVERIFY(std::abs(distance - mean) < 0.05 * mean);
    }
}

void StrokeFitTest::shake_isFilteredAndTurnsAreKept()
{
    const double ideal = turning(drawnStroke(60, 0.0, wave));
    const SketchLine shaky = drawnStroke(600, 0.5, wave);
    QVERIFY(turning(shaky) > 20.0 * ideal);
    const auto stroke = fitStroke(shaky);
    QVERIFY(stroke);
    QVERIFY(turning(stroke->line) < 1.5 * ideal);
    QVERIFY(turning(stroke->line) > 0.8 * ideal);
}

void StrokeFitTest::repeatedSamples_changeNothing()
{
    const SketchLine samples = drawnStroke(40, 0.0, wave);
    SketchLine repeated;
    for (const Eigen::Vector2d& sample : samples)
        repeated.insert(repeated.end(), 3, sample);
    QVERIFY(fitStroke(samples) == fitStroke(repeated));
}

void StrokeFitTest::reversedSamples_giveTheReversedLine()
{
    SketchLine samples = drawnStroke(100, 0.2, wave);
    const auto there = fitStroke(samples);
    std::ranges::reverse(samples);
    const auto back = fitStroke(samples);
    QVERIFY(there && back);
    QCOMPARE(there->line.size(), back->line.size());
    for (std::size_t i = 0; i < there->line.size(); ++i)
        QVERIFY((there->line[i] - back->line[back->line.size() - 1 - i]).norm() < 1e-6);
}

void StrokeFitTest::kind_isAsDrawn_data()
{
    QTest::addColumn<SketchLine>("samples");
    QTest::addColumn<SketchStroke::Kind>("kind");
    using Kind = SketchStroke::Kind;
    const auto arc = [](double turns) -> SketchLine {
        SketchLine line;
        for (int i = 0; i <= 60; ++i) {
            const double angle = 2.0 * std::numbers::pi * turns * i / 60.0;
            line.emplace_back(100.0 * std::cos(angle), 100.0 * std::sin(angle));
        }
        return line;
    };
    QTest::newRow("a tap") << SketchLine{{3.0, 4.0}} << Kind::Dot;
    QTest::newRow("a tap that trembles") << SketchLine{{3.0, 4.0}, {3.01, 4.0}, {3.0, 4.01}} << Kind::Dot;
    QTest::newRow("two points") << SketchLine{{0.0, 0.0}, {90.0, 10.0}} << Kind::Open;
    QTest::newRow("a line shorter than the gap")
        << SketchLine{{0.0, 0.0}, {3.0, 0.0}, {6.0, 0.0}} << Kind::Open;
    QTest::newRow("closed but for 8 %") << arc(0.92) << Kind::Closed;
    QTest::newRow("open by 20 %") << arc(0.80) << Kind::Open;
    QTest::newRow("a small loop, open by 7 px")
        << SketchLine{{0.0, 0.0}, {12.0, 12.0}, {7.0, 0.0}} << Kind::Closed;
    QTest::newRow("open by 9 px") << SketchLine{{0.0, 0.0}, {12.0, 12.0}, {9.0, 0.0}} << Kind::Open;
}

void StrokeFitTest::kind_isAsDrawn()
{
    QFETCH(const SketchLine, samples);
    QFETCH(const SketchStroke::Kind, kind);
    const auto stroke = fitStroke(samples);
    QVERIFY(stroke);
    QCOMPARE(stroke->kind, kind);
    const std::size_t least = kind == SketchStroke::Kind::Dot ? 1 : kind == SketchStroke::Kind::Open ? 2 : 3;
    QVERIFY(stroke->line.size() >= least);
    QCOMPARE(stroke->line.size() == 1, kind == SketchStroke::Kind::Dot);
}

void StrokeFitTest::loop_isClosedWithoutRepeatingItsFirstPoint()
{
    const auto stroke = fitStroke({{0.0, 0.0}, {100.0, 0.0}, {100.0, 80.0}, {0.0, 80.0}, {0.0, 3.0}});
    QVERIFY(stroke);
    QCOMPARE(stroke->kind, SketchStroke::Kind::Closed);
    const double closing = (stroke->line.back() - stroke->line.front()).norm();
    QVERIFY(closing > 0.5);
    QVERIFY(closing <= 6.1);
}

void StrokeFitTest::scribble_isBounded()
{
    SketchLine samples;
    for (int i = 0; i < 20'000; ++i)
        samples.emplace_back(500.0 * std::sin(0.3 * i), 0.05 * i);
    const auto stroke = fitStroke(samples);
    QVERIFY(stroke);
    QVERIFY(stroke->line.size() <= kMostSketchPoints);
}

void StrokeFitTest::nonsense_isRefused()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    QVERIFY(fitStroke({{0.0, 0.0}, {90.0, 10.0}}));
    QVERIFY(!fitStroke({}));
    QVERIFY(!fitStroke({{0.0, 0.0}, {nan, 1.0}, {90.0, 10.0}}));
    QVERIFY(!fitStroke({{0.0, 0.0}, {90.0, -infinity}}));
    QVERIFY(!fitStroke({{0.0, 0.0}, {2.0 * kFarthestSketchPoint, 0.0}}));
}

const TestClass<StrokeFitTest> strokeFitTest;

} // namespace espalier::test

#include "StrokeFitTest.moc"

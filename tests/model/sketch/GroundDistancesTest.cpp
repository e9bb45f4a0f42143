// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/GroundDistances.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <limits>

namespace espalier::test {

class GroundDistancesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void values_afterManyStamps_areThoseOfBruteForce();
    void stamp_takesFarLessThanAMillisecond();
    void clearance_knowsMeanAndLeast();
    void at_interpolatesAndEndsAtTheBorder();
};

namespace {

Eigen::AlignedBox2d groundBox()
{
    return {Eigen::Vector2d(-3.0, -2.0), Eigen::Vector2d(5.0, 2.0)};
}

} // namespace

void GroundDistancesTest::values_afterManyStamps_areThoseOfBruteForce()
{
    GroundDistances field(groundBox());
    QCOMPARE(field.value(5, 7), GroundDistances::kFarAway);
    QVERIFY(std::abs(field.cellSize() - 8.0 / GroundDistances::kCells) < 1e-12);
    Random random(1, 0, 0, Purpose::Texture);
    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> segments;
    for (int i = 0; i < 25; ++i) {
        const Eigen::Vector2d from(random.uniform(-4.0, 6.0), random.uniform(-4.0, 4.0));
        const Eigen::Vector2d to =
            i % 5 == 0 ? from : Eigen::Vector2d(random.uniform(-4.0, 6.0), random.uniform(-4.0, 4.0));
        segments.emplace_back(from, to);
        field.stamp(from, to);
    }
    for (int row = 0; row < GroundDistances::kCells; ++row) {
        for (int column = 0; column < GroundDistances::kCells; ++column) {
            const Eigen::Vector2d point = field.centre(column, row);
            double nearest = std::numeric_limits<double>::infinity();
            for (const auto& [from, to] : segments) {
                const Eigen::Vector2d step = to - from;
                const double square = step.squaredNorm();
                const double share =
                    square > 0.0 ? std::clamp((point - from).dot(step) / square, 0.0, 1.0) : 0.0;
                nearest = std::min(nearest, (point - from - share * step).norm());
            }
            QVERIFY(std::abs(field.value(column, row) - nearest) < 1e-5);
        }
    }
}

void GroundDistancesTest::stamp_takesFarLessThanAMillisecond()
{
    GroundDistances field(groundBox());
    qint64 least = std::numeric_limits<qint64>::max();
    for (int i = 0; i < 50; ++i) {
        QElapsedTimer timer;
        timer.start();
        field.stamp({0.0, 0.0}, {0.1 * i, 1.0});
        least = std::min(least, timer.nsecsElapsed());
    }
    QVERIFY2(least < 1'000'000, qPrintable(QStringLiteral("%1 ns").arg(least)));
}

void GroundDistancesTest::clearance_knowsMeanAndLeast()
{
    GroundDistances field(groundBox());
    field.stamp({0.0, -9.0}, {0.0, 9.0});
    const auto away = field.clearance({0.0, 0.0}, {2.0, 0.0});
    QVERIFY(std::abs(away.mean - 1.0) < 0.05);
    QVERIFY(std::abs(away.least - 0.4) < 0.1);
    const auto across = field.clearance({-1.0, 0.0}, {1.0, 0.0});
    QVERIFY(across.least < 0.07);
    QVERIFY(std::abs(across.mean - 0.5) < 0.05);
}

void GroundDistancesTest::at_interpolatesAndEndsAtTheBorder()
{
    GroundDistances field(groundBox());
    field.stamp({0.0, -9.0}, {0.0, 9.0});
    for (const double x : {0.5, 1.234, 3.3})
        QVERIFY(std::abs(field.at({x, 0.321}) - x) < 1e-5);
    QVERIFY(std::abs(field.at({50.0, 0.0}) - 5.0) < 0.1);
    QCOMPARE(GroundDistances(groundBox()).at({1.0, 1.0}), double{GroundDistances::kFarAway});
}

const TestClass<GroundDistancesTest> groundDistancesTest;

} // namespace espalier::test

#include "GroundDistancesTest.moc"

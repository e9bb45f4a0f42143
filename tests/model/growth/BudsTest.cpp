// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Buds.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class BudsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void terminalBud_pointsAlongItsInternode();
    void lateralBuds_leaveAtTheBranchingAngleEvenlyAround();
    void irregularity_spreadsAnglesAroundTheirMean();
    void direction_dependsOnTheKeyAlone();
    void newInternode_bearsATerminalAndItsLaterals();
};

namespace {

Rotation randomRotation(Random& random)
{
    return Rotation(Eigen::AngleAxisf(static_cast<float>(random.uniform(0.0, 6.0)), random.direction()));
}

} // namespace

void BudsTest::terminalBud_pointsAlongItsInternode()
{
    Random random(1, 0, 0, Purpose::Direction);
    for (InternodeId id = 0; id < 50; ++id) {
        const Rotation rotation = randomRotation(random);
        QVERIFY((budDirection(childKey(1, 0, id), kTerminalSlot, rotation, GrowthParameters()) -
                 rotation * Vec3(Vec3::UnitY()))
                    .norm() < 1e-6F);
    }
}

void BudsTest::lateralBuds_leaveAtTheBranchingAngleEvenlyAround()
{
    Random random(2, 0, 0, Purpose::Direction);
    GrowthParameters p;
    p.irregularity = 0.0;
    for (p.lateralsPerNode = 1; p.lateralsPerNode <= kMaxLaterals; ++p.lateralsPerNode) {
        p.branchingAngle = random.uniform(0.2, 2.5);
        const Rotation rotation = randomRotation(random);
        for (int slot = 0; slot < p.lateralsPerNode; ++slot) {
            const Vec3 local = rotation.conjugate() * budDirection(childKey(3, 0, 17), slot, rotation, p);
            QVERIFY(std::abs(local.norm() - 1.0F) < 1e-5F);
            QVERIFY(std::abs(std::acos(static_cast<double>(local.y())) - p.branchingAngle) < 1e-4);
            const double azimuth = std::atan2(static_cast<double>(local.z()), static_cast<double>(local.x()));
            const double expected = 2.0 * std::numbers::pi * slot / p.lateralsPerNode;
            QVERIFY(std::abs(std::remainder(azimuth - expected, 2.0 * std::numbers::pi)) < 1e-4);
        }
    }
}

void BudsTest::irregularity_spreadsAnglesAroundTheirMean()
{
    GrowthParameters p;
    p.branchingAngle = radians(60);
    double last = -1.0;
    for (const double irregularity : {0.0, 0.5, 1.0}) {
        p.irregularity = irregularity;
        double sum = 0.0;
        double squares = 0.0;
        constexpr int count = 4000;
        for (InternodeId id = 0; id < count; ++id) {
            const Vec3 bud = budDirection(childKey(5, 0, id), 0, Rotation::Identity(), p);
            const double angle = std::acos(std::clamp(static_cast<double>(bud.y()), -1.0, 1.0));
            sum += angle;
            squares += angle * angle;
        }
        const double mean = sum / count;
        const double spread = std::sqrt(std::max(0.0, squares / count - mean * mean));
        QVERIFY(std::abs(mean - p.branchingAngle) < radians(1));
        QVERIFY(spread > last);
        last = std::max(spread, 1e-6);
    }
    QVERIFY(last < radians(25));
}

void BudsTest::direction_dependsOnTheKeyAlone()
{
    const GrowthParameters p;
    const Vec3 direction = budDirection(childKey(7, 0, 11), 0, Rotation::Identity(), p);
    QCOMPARE(budDirection(childKey(7, 0, 11), 0, Rotation::Identity(), p), direction);
    QVERIFY(budDirection(childKey(8, 0, 11), 0, Rotation::Identity(), p) != direction);
    QVERIFY(budDirection(childKey(7, 0, 12), 0, Rotation::Identity(), p) != direction);
}

void BudsTest::newInternode_bearsATerminalAndItsLaterals()
{
    GrowthParameters p;
    for (p.lateralsPerNode = 1; p.lateralsPerNode <= kMaxLaterals; ++p.lateralsPerNode) {
        const BudMask buds = newBuds(p);
        QVERIFY((buds & kTerminalBud) != 0);
        QCOMPARE(std::popcount(static_cast<unsigned>(buds)), p.lateralsPerNode + 1);
        for (int slot = 0; slot < p.lateralsPerNode; ++slot)
            QVERIFY((buds & budBit(slot)) != 0);
    }
}

const TestClass<BudsTest> budsTest;

} // namespace espalier::test

#include "BudsTest.moc"

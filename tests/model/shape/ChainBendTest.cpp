// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/ChainBend.h"

#include "model/base/Vector.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace espalier::test {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

class ChainBendTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void faceEnergy_ofBendAndTwist_hasTheKnownValues();
    void energy_isZeroAtRestAlone();
    void energy_doesNotDependOnWhereTheBranchStands();
    void steps_neverRaiseTheEnergy();
    void prisms_stayRigid();
    void firstInternode_staysToTheLastBit();
    void handles_reachTheirTargets();
    void pose_followsItsSegments();
    void closedLoop_bringsTheBranchBack_data();
    void closedLoop_bringsTheBranchBack();
    void subdivision_hardlyChangesTheForm();
    void scale_scalesTheForm();
    void stiffness_keepsItsMeaning();
    void outOfReach_stretchesNoFurtherThanAllowed();
    void straightBranch_pushedFromItsTip_givesWay();
    void extremes_stayFinite_data();
    void extremes_stayFinite();
    void withoutFreePrism_nothingMoves();
    void handlesOfOneInternode_actAsOne();
    void sameCalls_giveTheSameBits();
};

namespace {

constexpr double kPi = std::numbers::pi;

/// A branch of @p length m that curves and twists, of @p count internodes.
ChainPose curvedBranch(std::size_t count, double length = 1.0)
{
    ChainPose pose;
    pose.nodes.push_back({0.3, 1.0, -0.2});
    Quaterniond rotation = Quaterniond::Identity();
    const double step = 1.0 / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double s = static_cast<double>(i) * step;
        rotation = rotation * AngleAxisd(0.9 * step * std::cos(3.0 * s), Vector3d::UnitZ()) *
                   AngleAxisd(0.5 * step, Vector3d::UnitX()) * AngleAxisd(2.4, Vector3d::UnitY());
        pose.rotations.push_back(rotation.normalized());
        pose.nodes.push_back(pose.nodes.back() + length * step * (rotation * Vector3d::UnitY()));
    }
    return pose;
}

ChainPose straightBranch(std::size_t count)
{
    ChainPose pose;
    for (std::size_t i = 0; i <= count; ++i)
        pose.nodes.push_back({0.0, static_cast<double>(i) / static_cast<double>(count), 0.0});
    pose.rotations.assign(count, Quaterniond::Identity());
    return pose;
}

ChainHandle tipOf(const ChainPose& pose)
{
    return {static_cast<std::uint32_t>(pose.rotations.size() - 1), 1.0};
}

ChainBend heldAtTheTip(const ChainPose& pose, const BendOptions& options = {})
{
    const ChainHandle tip = tipOf(pose);
    return {pose, std::span(&tip, 1), options};
}

bool pull(ChainBend& bend, const Vector3d& target)
{
    return bend.solve(std::span(&target, 1));
}

/// Pulls the tip along a line in @p calls.
void drag(ChainBend& bend, const Vector3d& target, int calls = 30)
{
    const Vector3d from = bend.pose().nodes.back();
    for (int i = 1; i <= calls; ++i)
        pull(bend, from + (target - from) * i / calls);
}

void settle(ChainBend& bend, const Vector3d& target)
{
    for (int i = 0; i < 200; ++i) {
        if (pull(bend, target))
            return;
    }
    QFAIL("did not settle");
}

double length(const ChainPose& pose)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < pose.rotations.size(); ++i)
        sum += (pose.nodes[i + 1] - pose.nodes[i]).norm();
    return sum;
}

double distance(const ChainPose& a, const ChainPose& b)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
        most = std::max(most, (a.nodes[i] - b.nodes[i]).norm());
    return most;
}

bool isFinite(const ChainPose& pose)
{
    return std::ranges::all_of(pose.nodes, [](const Vector3d& node) { return node.allFinite(); }) &&
           std::ranges::all_of(pose.rotations,
                               [](const Quaterniond& rotation) { return rotation.coeffs().allFinite(); });
}

bool descends(const ChainBend& bend)
{
    return std::ranges::all_of(bend.descents(), [](const ChainBend::Descent& descent) {
        return descent.after <= descent.before && descent.after >= 0.0;
    });
}

} // namespace

void ChainBendTest::faceEnergy_ofBendAndTwist_hasTheKnownValues()
{
    const Vector3d a(0.1, 0.0, 0.0);
    const Vector3d b(0.0, 0.0, 0.1);
    const Matrix3d straight = Matrix3d::Identity();
    const Matrix3d bent = AngleAxisd(0.2, Vector3d::UnitX()).toRotationMatrix();
    const Matrix3d twisted = AngleAxisd(0.2, Vector3d::UnitY()).toRotationMatrix();
    QVERIFY(std::abs(faceEnergy(straight, bent, a, b) - 1.32889481e-4) < 1e-12);
    QVERIFY(std::abs(faceEnergy(straight, twisted, a, b) - 2.65778962e-4) < 1e-12);
}

void ChainBendTest::energy_isZeroAtRestAlone()
{
    ChainBend bend = heldAtTheTip(curvedBranch(12));
    QCOMPARE(bend.energy(), 0.0);
    pull(bend, bend.rest().nodes.back() + Vector3d(0.01, 0.0, 0.0));
    QVERIFY(bend.energy() > 0.0);
    bend.reset();
    QCOMPARE(bend.energy(), 0.0);
    QCOMPARE(distance(bend.pose(), bend.rest()), 0.0);
}

void ChainBendTest::energy_doesNotDependOnWhereTheBranchStands()
{
    const ChainPose here = curvedBranch(15);
    const Quaterniond turn(AngleAxisd(1.1, Vector3d(1.0, 2.0, -0.5).normalized()));
    const Vector3d shift(3.0, -1.0, 7.0);
    ChainPose there = here;
    for (Vector3d& node : there.nodes)
        node = turn * node + shift;
    for (Quaterniond& rotation : there.rotations)
        rotation = turn * rotation;
    ChainBend one = heldAtTheTip(here);
    ChainBend other = heldAtTheTip(there);
    const Vector3d target = here.nodes.back() + Vector3d(0.3, -0.2, 0.2);
    settle(one, target);
    settle(other, turn * target + shift);
    // The faces are squares that may be turned about the branch; their energy is not.
    QVERIFY(std::abs(one.energy() - other.energy()) < 1e-6 * one.energy());
    for (std::size_t i = 0; i < here.nodes.size(); ++i)
        QVERIFY((turn * one.pose().nodes[i] + shift - other.pose().nodes[i]).norm() < 1e-4);
}

void ChainBendTest::steps_neverRaiseTheEnergy()
{
    for (const std::size_t count : {2U, 10U, 60U}) {
        ChainBend bend = heldAtTheTip(curvedBranch(count));
        std::size_t steps = 0;
        for (const Vector3d& target : {Vector3d(0.9, 1.3, 0.0), Vector3d(-8.0, 1.0, 3.0),
                                       Vector3d(0.3, 1.1, -0.2), Vector3d(0.3, 1.6, 0.4)}) {
            pull(bend, target);
            steps += bend.descents().size();
            QVERIFY(descends(bend));
        }
        QVERIFY(steps > 20);
    }
}

void ChainBendTest::prisms_stayRigid()
{
    ChainBend bend = heldAtTheTip(curvedBranch(25));
    for (int i = 0; i < 40; ++i)
        pull(bend, {std::sin(0.3 * i), 1.0 + std::cos(0.2 * i), 0.5 * std::sin(0.7 * i)});
    for (std::size_t i = 0; i < 25; ++i) {
        const Matrix3d& rotation = bend.prismRotation(i);
        QVERIFY((rotation.transpose() * rotation - Matrix3d::Identity()).norm() < 1e-9);
        QVERIFY(std::abs(rotation.determinant() - 1.0) < 1e-9);
    }
}

void ChainBendTest::firstInternode_staysToTheLastBit()
{
    ChainBend bend = heldAtTheTip(curvedBranch(20));
    drag(bend, {5.0, 3.0, -2.0});
    QVERIFY(bend.pose().nodes[0] == bend.rest().nodes[0]);
    QVERIFY(bend.pose().nodes[1] == bend.rest().nodes[1]);
    QVERIFY(bend.pose().rotations[0].coeffs() == bend.rest().rotations[0].coeffs());
    QVERIFY(bend.prismRotation(0) == Matrix3d::Identity());
}

void ChainBendTest::handles_reachTheirTargets()
{
    const ChainPose rest = curvedBranch(30);
    const std::array<ChainHandle, 3> handles{{{9, 0.3}, {15, 0.5}, {29, 1.0}}};
    ChainBend bend(rest, handles);
    std::array<Vector3d, 3> start;
    for (std::size_t i = 0; i < 3; ++i)
        start[i] =
            rest.nodes[handles[i].internode] +
            handles[i].along * (rest.nodes[handles[i].internode + 1] - rest.nodes[handles[i].internode]);
    std::array<Vector3d, 3> targets;
    for (int step = 1; step <= 60; ++step) {
        const double s = std::min(1.0, step / 40.0);
        targets = {start[0] + s * Vector3d(0.08, -0.02, 0.0), start[1] + s * Vector3d(0.1, -0.05, 0.1),
                   start[2] + s * Vector3d(-0.2, -0.3, 0.1)};
        bend.solve(targets);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3d& lower = bend.pose().nodes[handles[i].internode];
        const Vector3d& upper = bend.pose().nodes[handles[i].internode + 1];
        const Vector3d held = lower + handles[i].along * (upper - lower);
        QVERIFY((held - targets[i]).norm() < 1e-3 / 30.0);
    }
    QVERIFY(std::abs(length(bend.pose()) - 1.0) < 0.1);
}

void ChainBendTest::pose_followsItsSegments()
{
    ChainBend bend = heldAtTheTip(curvedBranch(20));
    drag(bend, {1.0, 1.2, 0.3});
    for (std::size_t i = 0; i < 20; ++i) {
        const Vector3d segment = (bend.pose().nodes[i + 1] - bend.pose().nodes[i]).normalized();
        QVERIFY((bend.pose().rotations[i] * Vector3d::UnitY() - segment).norm() < 1e-9);
        QVERIFY(std::abs(bend.pose().rotations[i].norm() - 1.0) < 1e-12);
        // The twist is the prism's, except for the small turn that closes the gaps.
        const Quaterniond carried = Quaterniond(bend.prismRotation(i)) * bend.rest().rotations[i];
        QVERIFY(bend.pose().rotations[i].angularDistance(carried) < 0.15);
    }
}

void ChainBendTest::closedLoop_bringsTheBranchBack_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("calls");
    for (const int count : {2, 10, 40, 160}) {
        for (const int calls : {24, 200})
            QTest::addRow("%d internodes, %d calls", count, calls) << count << calls;
    }
}

void ChainBendTest::closedLoop_bringsTheBranchBack()
{
    QFETCH(const int, count);
    QFETCH(const int, calls);
    ChainBend bend = heldAtTheTip(curvedBranch(static_cast<std::size_t>(count)));
    const Vector3d base = bend.rest().nodes[1];
    const Vector3d reach = bend.rest().nodes.back() - base;
    double furthest = 0.0;
    for (int i = 1; i <= calls; ++i) {
        // Around an oval, as far as 85 degrees away, and nearer to the base on the way.
        const double s = 2.0 * kPi * i / calls;
        const Quaterniond turn = AngleAxisd(radians(42.5) * (1.0 - std::cos(s)), Vector3d::UnitZ()) *
                                 AngleAxisd(radians(40.0) * std::sin(s), Vector3d::UnitX());
        pull(bend, base + (1.0 - 0.1 * (1.0 - std::cos(s))) * (turn * reach));
        furthest = std::max(furthest, distance(bend.pose(), bend.rest()));
    }
    QVERIFY(furthest > 0.3);
    QVERIFY(distance(bend.pose(), bend.rest()) < 1e-6);
}

void ChainBendTest::subdivision_hardlyChangesTheForm()
{
    constexpr std::size_t kCount = 20;
    const ChainPose coarse = curvedBranch(kCount);
    ChainPose fine;
    fine.nodes = {coarse.nodes[0], coarse.nodes[1]};
    fine.rotations = {coarse.rotations[0]};
    for (std::size_t i = 1; i < kCount; ++i) {
        fine.nodes.push_back(0.5 * (coarse.nodes[i] + coarse.nodes[i + 1]));
        fine.nodes.push_back(coarse.nodes[i + 1]);
        fine.rotations.insert(fine.rotations.end(), 2, coarse.rotations[i]);
    }
    for (const Vector3d& shift :
         {Vector3d(0.4, -0.3, 0.2), Vector3d(-0.9, -0.6, 0.1), Vector3d(0.0, -0.4, 0.3)}) {
        ChainBend one = heldAtTheTip(coarse);
        ChainBend other = heldAtTheTip(fine);
        const Vector3d target = coarse.nodes.back() + shift;
        drag(one, target);
        drag(other, target);
        settle(one, target);
        settle(other, target);
        for (std::size_t i = 1; i <= kCount; ++i)
            QVERIFY((one.pose().nodes[i] - other.pose().nodes[2 * i - 1]).norm() < 0.05 / kCount);
    }
}

void ChainBendTest::scale_scalesTheForm()
{
    ChainPose large = curvedBranch(15);
    for (Vector3d& node : large.nodes)
        node *= 100.0;
    ChainBend one = heldAtTheTip(curvedBranch(15));
    ChainBend other = heldAtTheTip(large);
    const Vector3d target(0.9, 1.4, 0.1);
    drag(one, target);
    drag(other, 100.0 * target);
    for (std::size_t i = 0; i < one.pose().nodes.size(); ++i)
        QVERIFY((100.0 * one.pose().nodes[i] - other.pose().nodes[i]).norm() < 1e-4);
}

void ChainBendTest::stiffness_keepsItsMeaning()
{
    const ChainPose rest = curvedBranch(20);
    const Vector3d target = rest.nodes.back() + Vector3d(0.5, -0.2, 0.0);
    const auto lost = [&](const BendOptions& options) {
        ChainBend bend = heldAtTheTip(rest, options);
        drag(bend, target);
        return std::abs(length(bend.pose()) - 1.0);
    };
    QVERIFY(lost({.bending = 10.0}) > 2.0 * lost({}));
    QVERIFY(lost({.stretching = 10.0}) < 0.5 * lost({}));
    QVERIFY(lost({.stretching = 100.0}) < 1e-3);
}

void ChainBendTest::outOfReach_stretchesNoFurtherThanAllowed()
{
    for (const double most : {1.0, 1.5, 2.0}) {
        ChainBend bend = heldAtTheTip(curvedBranch(20), {.mostStretch = most});
        const Vector3d base = bend.rest().nodes[1];
        drag(bend, base + Vector3d(10.0, 1.0, 0.0));
        settle(bend, base + Vector3d(10.0, 1.0, 0.0));
        QVERIFY(std::abs(length(bend.pose()) / (0.05 + 0.95 * most) - 1.0) < 0.06);
        for (std::size_t i = 1; i < 20; ++i)
            QVERIFY((bend.pose().nodes[i + 1] - bend.pose().nodes[i]).norm() < 1.15 * most * 0.05);
    }
}

void ChainBendTest::straightBranch_pushedFromItsTip_givesWay()
{
    ChainBend bend = heldAtTheTip(straightBranch(20));
    drag(bend, {0.0, 0.5, 0.0});
    settle(bend, {0.0, 0.5, 0.0});
    QVERIFY(length(bend.pose()) > 0.95);
}

void ChainBendTest::extremes_stayFinite_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("withHoles");
    for (const int count : {1, 2, 3, 10, 200}) {
        QTest::addRow("%d internodes", count) << count << false;
        QTest::addRow("%d internodes, some of length 0", count) << count << true;
    }
}

void ChainBendTest::extremes_stayFinite()
{
    QFETCH(const int, count);
    QFETCH(const bool, withHoles);
    ChainPose rest = curvedBranch(static_cast<std::size_t>(count));
    if (withHoles) {
        for (std::size_t i = 1; i < rest.nodes.size(); ++i) {
            if (i % 3 != 1)
                rest.nodes[i] = rest.nodes[i - 1];
        }
    }
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Vector3d base = rest.nodes[1];
    const std::array<ChainHandle, 5> handles{
        {tipOf(rest), {0, 0.5}, {1, 0.0}, {1, 1.0}, {static_cast<std::uint32_t>(count / 2), kNaN}}};
    for (const std::size_t held : {1U, 5U}) {
        ChainBend bend(rest, std::span(handles).first(held));
        for (const Vector3d& target :
             {base, Vector3d(10.0, 0.0, 0.0), Vector3d(base - rest.nodes.back()), Vector3d(0.0, -10.0, 0.0),
              Vector3d(1e300, 1e300, -1e300), Vector3d(kNaN, 0.0, 0.0), Vector3d(0.0, kInfinity, 0.0),
              rest.nodes[0]}) {
            const std::vector<Vector3d> targets(held, target);
            for (int i = 0; i < 5; ++i) {
                bend.solve(targets);
                QVERIFY(isFinite(bend.pose()));
                QVERIFY(std::isfinite(bend.energy()));
                QVERIFY(descends(bend));
                QVERIFY(length(bend.pose()) < 20.0);
            }
        }
    }
}

void ChainBendTest::withoutFreePrism_nothingMoves()
{
    ChainBend single = heldAtTheTip(curvedBranch(1));
    QVERIFY(pull(single, {3.0, 0.0, 0.0}));
    QCOMPARE(distance(single.pose(), single.rest()), 0.0);

    const ChainHandle atTheBase{0, 1.0};
    ChainBend held(curvedBranch(5), std::span(&atTheBase, 1));
    QVERIFY(pull(held, {3.0, 0.0, 0.0}));
    QCOMPARE(distance(held.pose(), held.rest()), 0.0);

    ChainBend loose(curvedBranch(5), {});
    QVERIFY(loose.solve({}));
    QCOMPARE(distance(loose.pose(), loose.rest()), 0.0);
}

void ChainBendTest::handlesOfOneInternode_actAsOne()
{
    const ChainPose rest = curvedBranch(12);
    const std::array<ChainHandle, 2> two{{{11, 0.2}, {11, 0.8}}};
    const ChainHandle one{11, 0.5};
    ChainBend both(rest, two);
    ChainBend single(rest, std::span(&one, 1));
    const Vector3d target = rest.nodes.back() + Vector3d(0.2, -0.1, 0.0);
    both.solve(std::vector<Vector3d>{target + Vector3d(0.0, 0.1, 0.0), target - Vector3d(0.0, 0.1, 0.0)});
    single.solve(std::span(&target, 1));
    QVERIFY(distance(both.pose(), single.pose()) < 1e-9);
    QVERIFY(distance(both.pose(), rest) > 0.1);
}

void ChainBendTest::sameCalls_giveTheSameBits()
{
    ChainBend one = heldAtTheTip(curvedBranch(50));
    ChainBend other = heldAtTheTip(curvedBranch(50));
    other.solve(std::vector<Vector3d>{Vector3d(2.0, 0.0, 0.0)});
    other.reset();
    for (int i = 0; i < 20; ++i) {
        const Vector3d target(std::sin(0.2 * i), 1.5, 0.05 * i);
        pull(one, target);
        pull(other, target);
    }
    QCOMPARE(distance(one.pose(), other.pose()), 0.0);
    QCOMPARE(one.energy(), other.energy());
}

const TestClass<ChainBendTest> chainBendTest;

} // namespace espalier::test

#include "ChainBendTest.moc"

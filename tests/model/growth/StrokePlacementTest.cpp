// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/StrokePlacement.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class StrokePlacementTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bareTrunk_hasNoGap();
    void oneLimb_leavesTheOtherSide();
    void limbs_leaveTheirWidestGap();
    void shootsThatAreShortBesideTheLimbs_doNotCount();
    void spread_keepsLengthAndElevation();
    void spread_keepsTheSideUntilTheStrokeHasADirection();
    void copies_standEvenlyAroundTheLine();
    void trunk_isFoundAtAHeight();
};

namespace {

/// A trunk of 1 m, and limbs of @p lengths internodes of 0.1 m at these azimuths, degrees from +X toward +Z.
TreeBuilder trunkWithLimbs(const std::vector<std::pair<double, int>>& limbs)
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    TreeBuilder builder(1, parameters);
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < 10; ++i)
        internodes.push_back({.parent = i});
    InternodeId bearer = 3;
    for (const auto& [azimuth, length] : limbs) {
        const Eigen::Quaternionf around(
            Eigen::AngleAxisf(static_cast<float>(-radians(azimuth)), Vec3::UnitY()));
        const Eigen::Quaternionf out(Eigen::AngleAxisf(-1.2F, Vec3::UnitZ()));
        internodes.push_back(
            {.parent = bearer++, .slot = 0, .rotation = Rotation((around * out).normalized())});
        for (int i = 1; i < length; ++i)
            internodes.push_back({.parent = static_cast<InternodeId>(internodes.size())});
    }
    builder.apply(births(builder.tree, internodes));
    return builder;
}

/// The difference between two azimuths, degrees, −180...180.
double turnBetween(double a, double b)
{
    return std::remainder(a - b, 360.0);
}

const Vec3 kAround(0.0F, 0.5F, 0.0F);

double gapOf(const std::vector<std::pair<double, int>>& limbs)
{
    const TreeBuilder builder = trunkWithLimbs(limbs);
    return degrees(widestGap(builder.tree, builder.index, kAround).value_or(1e9));
}

} // namespace

void StrokePlacementTest::bareTrunk_hasNoGap()
{
    const TreeBuilder builder = trunkWithLimbs({});
    QVERIFY(!widestGap(builder.tree, builder.index, kAround));
    StrokeTurns turns(builder.tree, builder.index, {.around = kAround, .isSpread = true}, 0.1F);
    const Vec3 point(0.3F, 0.7F, 0.1F);
    turns.meet(point);
    QCOMPARE(turns.placed(point, 0), point);
}

void StrokePlacementTest::oneLimb_leavesTheOtherSide()
{
    QVERIFY(std::abs(turnBetween(gapOf({{30.0, 5}}), 210.0)) < 1.0);
}

void StrokePlacementTest::limbs_leaveTheirWidestGap()
{
    QVERIFY(std::abs(turnBetween(gapOf({{0.0, 5}, {90.0, 5}}), 225.0)) < 1.0);
    QVERIFY(std::abs(turnBetween(gapOf({{0.0, 5}, {90.0, 5}, {200.0, 4}, {300.0, 4}}), 145.0)) < 1.0);
}

void StrokePlacementTest::shootsThatAreShortBesideTheLimbs_doNotCount()
{
    QVERIFY(std::abs(turnBetween(gapOf({{0.0, 9}, {180.0, 1}}), 180.0)) < 1.0);
}

void StrokePlacementTest::spread_keepsLengthAndElevation()
{
    const TreeBuilder builder = trunkWithLimbs({{0.0, 5}});
    StrokeTurns turns(builder.tree, builder.index, {.around = kAround, .isSpread = true}, 0.1F);
    // Drawn over the limb that is there.
    const Vec3 first = kAround + Vec3(0.4F, 0.2F, 0.0F);
    const Vec3 last = kAround + Vec3(0.9F, 0.3F, 0.0F);
    turns.meet(kAround);
    turns.meet(first);
    turns.meet(last);
    QVERIFY((turns.placed(first, 0) - (kAround + Vec3(-0.4F, 0.2F, 0.0F))).norm() < 0.01F);
    QVERIFY((turns.placed(last, 0) - (kAround + Vec3(-0.9F, 0.3F, 0.0F))).norm() < 0.02F);
    // A stroke to the left leads into the same gap.
    StrokeTurns left(builder.tree, builder.index, {.around = kAround, .isSpread = true}, 0.1F);
    left.meet(kAround + Vec3(-0.4F, 0.2F, 0.0F));
    QVERIFY((left.placed(kAround + Vec3(-0.4F, 0.2F, 0.0F), 0) - turns.placed(first, 0)).norm() < 0.01F);
}

void StrokePlacementTest::spread_keepsTheSideUntilTheStrokeHasADirection()
{
    const TreeBuilder builder = trunkWithLimbs({{0.0, 5}});
    StrokeTurns turns(builder.tree, builder.index, {.around = kAround, .isSpread = true}, 0.1F);
    const Vec3 near = kAround + Vec3(0.05F, 0.0F, 0.0F);
    turns.meet(near);
    QCOMPARE(turns.placed(near, 0), near);
    // Once it has one, it keeps it.
    turns.meet(kAround + Vec3(0.2F, 0.0F, 0.0F));
    turns.meet(kAround + Vec3(0.0F, 0.0F, 0.5F));
    QVERIFY(turns.placed(near, 0).x() < 0.0F);
}

void StrokePlacementTest::copies_standEvenlyAroundTheLine()
{
    const TreeBuilder builder = trunkWithLimbs({});
    const StrokeTurns turns(builder.tree, builder.index, {.around = kAround, .copies = 4}, 0.1F);
    const Vec3 point = kAround + Vec3(0.6F, 0.3F, 0.2F);
    QCOMPARE(turns.placed(point, 0), point);
    for (int copy = 0; copy < 4; ++copy) {
        const Vec3 here = turns.placed(point, copy) - kAround;
        const Vec3 next = turns.placed(point, (copy + 1) % 4) - kAround;
        QVERIFY(std::abs(here.y() - 0.3F) < 1e-6F);
        QVERIFY(std::abs(here.norm() - (point - kAround).norm()) < 1e-5F);
        QVERIFY(std::abs(here.x() * next.x() + here.z() * next.z()) < 1e-5F);
    }
}

void StrokePlacementTest::trunk_isFoundAtAHeight()
{
    const TreeBuilder builder = trunkWithLimbs({{0.0, 5}});
    QVERIFY((trunkAt(builder.tree, builder.index, 0, 0.43F) - Vec3(0.0F, 0.43F, 0.0F)).norm() < 1e-4F);
    QVERIFY((trunkAt(builder.tree, builder.index, 0, 9.0F) - builder.index.nodePosition(10)).norm() < 1e-4F);
}

static const TestClass<StrokePlacementTest> strokePlacementTest;

} // namespace espalier::test

#include "StrokePlacementTest.moc"

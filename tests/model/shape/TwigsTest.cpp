// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Twigs.h"

#include "model/shape/Pruning.h"
#include "tests/support/PlacedLeaves.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <algorithm>
#include <array>

namespace espalier::test {

class TwigsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void brush_sweepsWhatAppearsUnderIt_howeverFarBehind();
    void nearSide_leavesWhatIsBehindTheTrunk();
    void partsOfAPath_sweepTheSameAsTheWhole();
    void eraser_takesThinWoodAlone();
    void eraser_takesPlacedLeavesOnThickWood();
    void thinning_takesTheShareEvenly();
    void thinning_ofAllTakesAll();
    void thinning_takesWholeTwigs();
};

namespace {

constexpr int kTwigs = 40;

/// A trunk of 41 internodes of 0.1 m, each of which but the first carries a twig of two internodes, by turns
/// toward +X, +Z, −X, −Z.
TreeBuilder mast()
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    parameters.growth.lateralsPerNode = 2;
    parameters.widths.baseDiameter = 0.1;
    parameters.widths.tipDiameter = 0.004;
    TreeBuilder builder(3, parameters);
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < kTwigs; ++i)
        internodes.push_back({.parent = i});
    for (InternodeId i = 1; i <= kTwigs; ++i) {
        const Eigen::Quaternionf around(
            Eigen::AngleAxisf(-0.5F * std::numbers::pi_v<float> * static_cast<float>(i), Vec3::UnitY()));
        const Eigen::Quaternionf out(Eigen::AngleAxisf(-0.5F * std::numbers::pi_v<float>, Vec3::UnitZ()));
        internodes.push_back({.parent = i, .slot = 0, .rotation = Rotation((around * out).normalized())});
        internodes.push_back({.parent = static_cast<InternodeId>(internodes.size())});
    }
    builder.apply(births(builder.tree, internodes));
    return builder;
}

InternodeId twigAt(InternodeId trunk)
{
    return kTwigs + 1 + 2 * (trunk - 1);
}

const Vec3 kEye(0.0F, 2.0F, 20.0F);

} // namespace

void TwigsTest::brush_sweepsWhatAppearsUnderIt_howeverFarBehind()
{
    const TreeBuilder builder = mast();
    // Before the trunk, where twigs toward the eye and away from it appear.
    const SeenWood seen(builder.tree, builder.index, kEye, Vec3(0.0F, 2.0F, 0.0F), SweepDepth::All);
    const SweepPoint brush{Vec3(0.0F, 2.0F, 0.0F), 0.22F};
    const Swept swept = seen.under(brush, brush);
    bool isNear = false;
    bool isFar = false;
    for (const InternodeId id : swept.internodes) {
        QVERIFY(std::abs(builder.index.nodePosition(id).y() - 2.0F) < 0.4F);
        isNear = isNear || builder.index.nodePosition(id).z() > 0.05F;
        isFar = isFar || builder.index.nodePosition(id).z() < -0.05F;
    }
    QVERIFY(isNear);
    QVERIFY(isFar);
    QVERIFY(std::ranges::is_sorted(swept.internodes));
    // Beside the tree there is nothing.
    const SweepPoint beside{Vec3(2.0F, 2.0F, 0.0F), 0.12F};
    QVERIFY(seen.under(beside, beside).internodes.empty());
    // A quick stroke across sweeps what is between its samples.
    QVERIFY(
        !seen.under({Vec3(-2.0F, 2.0F, 0.0F), 0.05F}, {Vec3(2.0F, 2.0F, 0.0F), 0.05F}).internodes.empty());
}

void TwigsTest::nearSide_leavesWhatIsBehindTheTrunk()
{
    const TreeBuilder builder = mast();
    const SeenWood seen(builder.tree, builder.index, kEye, Vec3(0.0F, 2.0F, 0.0F), SweepDepth::NearSide);
    const SweepPoint brush{Vec3(0.0F, 2.0F, 0.0F), 1.0F};
    int found = 0;
    for (const InternodeId id : seen.under(brush, brush).internodes) {
        QVERIFY(builder.index.nodePosition(id).z() > -0.06F);
        found += builder.index.nodePosition(id).z() > 0.05F ? 1 : 0;
    }
    QVERIFY(found > 4);
}

void TwigsTest::partsOfAPath_sweepTheSameAsTheWhole()
{
    const TreeBuilder builder = mast();
    Sweep sweep{kEye, {}};
    for (int i = 0; i < 12; ++i)
        sweep.path.push_back(
            {Vec3(0.1F * static_cast<float>(i % 4) - 0.1F, 0.3F * static_cast<float>(i), 0.0F), 0.07F});
    const SeenWood seen(builder.tree, builder.index, kEye, sweep.path.front().position, SweepDepth::All);
    Swept parts = seen.under(sweep.path.front(), sweep.path.front());
    for (std::size_t i = 1; i < sweep.path.size(); ++i)
        parts.add(seen.under(sweep.path[i - 1], sweep.path[i]));
    const Swept whole = sweptBy(builder.tree, builder.index, std::array{sweep}, SweepDepth::All);
    QVERIFY(!whole.internodes.empty());
    QCOMPARE(parts.internodes, whole.internodes);
}

void TwigsTest::eraser_takesThinWoodAlone()
{
    const TreeBuilder builder = mast();
    const Sweep sweep{kEye, {{Vec3(0.0F, 0.0F, 0.0F), 0.5F}, {Vec3(0.0F, 4.2F, 0.0F), 0.5F}}};
    const Swept swept = sweptBy(builder.tree, builder.index, std::array{sweep}, SweepDepth::All);
    const TreeDelta delta =
        eraseTwigs(builder.tree, builder.index, swept, TwigRule(builder.tree, builder.index, 0.2));
    // All twigs, and the thin end of the trunk, but not the trunk.
    for (InternodeId i = 1; i <= kTwigs; ++i)
        QVERIFY(std::ranges::binary_search(delta.died, twigAt(i)));
    QVERIFY(!std::ranges::binary_search(delta.died, 1U));
    QVERIFY(!std::ranges::binary_search(delta.died, 20U));
    // At a share of 1, everything goes but the root.
    const TreeDelta all =
        eraseTwigs(builder.tree, builder.index, swept, TwigRule(builder.tree, builder.index, 1.0));
    QCOMPARE(all.died.size(), std::size_t{builder.tree.size() - 1});
}

void TwigsTest::eraser_takesPlacedLeavesOnThickWood()
{
    TreeBuilder builder = mast();
    builder.apply(leafPlacement(builder.tree, std::array<InternodeId, 2>{5, 30}));
    const Sweep sweep{kEye, {{builder.index.nodePosition(5), 0.1F}}};
    const TreeDelta delta = eraseTwigs(
        builder.tree, builder.index, sweptBy(builder.tree, builder.index, std::array{sweep}, SweepDepth::All),
        TwigRule(builder.tree, builder.index, 0.01));
    QVERIFY(delta.died.empty());
    QVERIFY(delta.leaves.death.size() >= 1);
    for (const auto& change : delta.leaves.death)
        QCOMPARE(builder.tree.placedLeaves().internode[change.row], 5U);
}

void TwigsTest::thinning_takesTheShareEvenly()
{
    const TreeBuilder builder = mast();
    const Sweep sweep{kEye, {{Vec3(0.0F, 0.0F, 0.0F), 0.5F}, {Vec3(0.0F, 4.2F, 0.0F), 0.5F}}};
    const Swept swept = sweptBy(builder.tree, builder.index, std::array{sweep}, SweepDepth::All);
    const TwigRule rule(builder.tree, builder.index, 0.2);
    for (const double share : {0.25, 0.4, 0.6}) {
        const std::vector<InternodeId> cuts = Thinning(builder.tree, builder.index, rule, share).cuts(swept);
        const double wanted = share * kTwigs;
        QVERIFY(std::abs(static_cast<double>(cuts.size()) - wanted) <= 2.0);
        // Among any ten neighbours, about as many go.
        for (InternodeId first = 1; first + 9 <= kTwigs; ++first) {
            int gone = 0;
            for (InternodeId i = first; i < first + 10; ++i)
                gone += std::ranges::binary_search(cuts, twigAt(i)) ? 1 : 0;
            QVERIFY(std::abs(gone - 10.0 * share) <= 1.6);
        }
        QCOMPARE(Thinning(builder.tree, builder.index, rule, share).cuts(swept), cuts);
    }
}

void TwigsTest::thinning_ofAllTakesAll()
{
    const TreeBuilder builder = mast();
    const Sweep sweep{kEye, {{Vec3(0.0F, 0.0F, 0.0F), 0.5F}, {Vec3(0.0F, 4.2F, 0.0F), 0.5F}}};
    const Swept swept = sweptBy(builder.tree, builder.index, std::array{sweep}, SweepDepth::All);
    const TwigRule rule(builder.tree, builder.index, 0.2);
    QCOMPARE(Thinning(builder.tree, builder.index, rule, 1.0).cuts(swept).size(), std::size_t{kTwigs});
    QVERIFY(Thinning(builder.tree, builder.index, rule, 0.0).cuts(swept).empty());
}

void TwigsTest::thinning_takesWholeTwigs()
{
    const TreeBuilder builder = mast();
    // The outer end of one twig.
    const InternodeId twig = twigAt(20);
    const Sweep sweep{kEye, {{builder.index.nodePosition(twig + 1), 0.01F}}};
    const Swept swept = sweptBy(builder.tree, builder.index, std::array{sweep}, SweepDepth::All);
    const std::vector<InternodeId> cuts =
        Thinning(builder.tree, builder.index, TwigRule(builder.tree, builder.index, 0.2), 1.0).cuts(swept);
    QVERIFY(std::ranges::binary_search(cuts, twig));
    QVERIFY(!std::ranges::binary_search(cuts, twig + 1));
}

static const TestClass<TwigsTest> twigsTest;

} // namespace espalier::test

#include "TwigsTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandReliefs.h"

#include "model/mesh/StrandMesher.h"
#include "model/shape/Pruning.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class StrandReliefsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wood_ofFewStrandsIsRound();
    void flutesOfZero_leaveTheWoodRound();
    void ridge_isBelowItsLimbAndFades();
    void buttresses_areAtTheGroundBelowLimbs();
    void lostLimb_leavesAHollowWithARim();
    void lostTwig_leavesNone();
    void hollow_shrinksAsTheWoodThickens();
    void hollow_isSeenInTheMesh();
    void hollow_isOnTheLimbsSideOfTwistedWood();
    void hollow_fadesTowardAProfile();
    void profile_isShownAsDrawn();
    void places_keepTheirOrder();
};

namespace {

constexpr InternodeId kFork = 20; ///< Whose node bears the limb of treeWithLimb()

/// Adds a branch of @p tips tips, a row of twigs, to @p parent.
InternodeId growBranch(TreeBuilder& builder, InternodeId parent, int slot, const Rotation& first,
                       std::uint32_t tips)
{
    const InternodeId begin = builder.tree.size();
    builder.growAxis(parent, slot, first, tips);
    for (InternodeId id = begin; id + 1 < begin + tips; ++id)
        builder.grow({.parent = id, .slot = 0, .rotation = branching(1.0)});
    return begin;
}

/// A trunk of 31 internodes that carries 160 tips at its top, and a limb of @p tips tips that leaves it level
/// from the middle.
TreeBuilder treeWithLimb(std::uint32_t tips, double flutes = 1.0)
{
    TreeParameters parameters;
    parameters.wood.flutes = flutes;
    parameters.widths.baseDiameter = 0.3;
    TreeBuilder builder(1, parameters);
    builder.growAxis(0, kTerminalSlot, continuing(), 30, continuing());
    if (tips > 0)
        growBranch(builder, kFork, 0, branching(radians(90)), tips);
    growBranch(builder, 30, kTerminalSlot, continuing(), 160);
    return builder;
}

/// The angle of a branch's first internode in the section of the node that it leaves.
float angleOf(const StrandLayouts& layouts, const TreeIndex& index, std::uint32_t node, InternodeId branch)
{
    const Vec3 local = layouts.skeleton().nodes[node].frame.conjugate() * index.heading(branch);
    return std::atan2(local.z(), local.x());
}

/// How far the outline is moved in all, as a share of the radius.
float reliefAt(const StrandLayouts& layouts, std::uint32_t node, float angle)
{
    return layouts.reliefs().ridge(node, angle) +
           layouts.reliefs().hollow(node, layouts.skeleton().nodes[node].radius, angle);
}

float meanRelief(const StrandLayouts& layouts, std::uint32_t node)
{
    float sum = 0.0F;
    for (int i = 0; i < 360; ++i)
        sum += reliefAt(layouts, node, static_cast<float>(radians(i)));
    return sum / 360.0F;
}

float greatestRelief(const StrandLayouts& layouts, std::uint32_t node)
{
    float greatest = 0.0F;
    for (int i = 0; i < 360; ++i)
        greatest = std::max(greatest, std::abs(reliefAt(layouts, node, static_cast<float>(radians(i)))));
    return greatest;
}

/// The horizontal direction in which a limb left the trunk.
Vec3 outwardOf(const TreeBuilder& builder, InternodeId limb)
{
    const Vec3 heading =
        builder.index.rotation(builder.tree.parent(limb)) * (builder.tree.columns().rotation[limb] * up());
    return Vec3(heading.x(), 0.0F, heading.z()).normalized();
}

/// How far the bark is from the middle of the upright trunk at @p place on one side, m; 0 if none is there.
float barkToward(const StrandLayouts& layouts, const TreeBuilder& builder, const Vec3& place,
                 const Vec3& side)
{
    constexpr float kSlice = 0.03F; // Half the height that is looked at, m
    const BranchMesh mesh = meshStrands(layouts, builder.tree.parameters());
    float sum = 0.0F;
    int count = 0;
    for (const MeshVertex& vertex : mesh.vertices) {
        const Vec3 from = toVec3(vertex.position) - place;
        const Vec3 flat(from.x(), 0.0F, from.z());
        if (std::abs(from.y()) > kSlice || flat.normalized().dot(side) < 0.98F)
            continue;
        sum += flat.norm();
        ++count;
    }
    return sum / static_cast<float>(std::max(count, 1));
}

} // namespace

void StrandReliefsTest::wood_ofFewStrandsIsRound()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 20, continuing());
    growBranch(builder, 10, 0, branching(1.2), StrandReliefs::kFewestStrands - 2);
    const StrandLayouts layouts = layoutsOf(builder);
    for (std::uint32_t node = 0; node < layouts.skeleton().nodes.size(); ++node) {
        QVERIFY(layouts.strandCount(node) < StrandReliefs::kFewestStrands);
        QCOMPARE(greatestRelief(layouts, node), 0.0F);
    }
}

void StrandReliefsTest::flutesOfZero_leaveTheWoodRound()
{
    const StrandLayouts flat = layoutsOf(treeWithLimb(60, 0.0));
    const StrandLayouts fluted = layoutsOf(treeWithLimb(60, 1.0));
    float greatest = 0.0F;
    for (std::uint32_t node = 0; node < flat.skeleton().nodes.size(); ++node) {
        QCOMPARE(greatestRelief(flat, node), 0.0F);
        greatest = std::max(greatest, greatestRelief(fluted, node));
    }
    QVERIFY(greatest > 0.1F);
}

void StrandReliefsTest::ridge_isBelowItsLimbAndFades()
{
    const TreeBuilder builder = treeWithLimb(60);
    const StrandLayouts layouts = layoutsOf(builder);
    const InternodeId limb = 31;
    QCOMPARE(builder.tree.parent(limb), kFork);
    const std::uint32_t fork = nodeOf(layouts, kFork);
    const float angle = angleOf(layouts, builder.index, fork, limb);
    QVERIFY(reliefAt(layouts, fork, angle) > 0.1F);
    QVERIFY(reliefAt(layouts, fork, angle + static_cast<float>(radians(180))) < 0.0F);
    QVERIFY(std::abs(meanRelief(layouts, fork)) < 1e-3F);
    // The trunk is straight, so the limb's side has the same angle all the way down.
    float above = reliefAt(layouts, fork, angle);
    for (InternodeId id = kFork - 1; id > 8; --id) {
        const float here = reliefAt(layouts, nodeOf(layouts, id), angle);
        QVERIFY(here > 0.0F && here < above);
        above = here;
    }
    // Above the limb the wood has no ridge of that limb.
    const std::uint32_t next = nodeOf(layouts, kFork + 1);
    QVERIFY(std::abs(reliefAt(layouts, next, angle)) < 0.03F);
}

void StrandReliefsTest::buttresses_areAtTheGroundBelowLimbs()
{
    TreeBuilder builder = treeWithLimb(60);
    growBranch(builder, 22, 0, branching(radians(90), 1, 3), 60);
    growBranch(builder, 24, 0, branching(radians(90), 2, 3), 60);
    const StrandLayouts layouts = layoutsOf(builder);
    const std::uint32_t base = layouts.skeleton().bases.front();
    const auto bulgesAt = [&](std::uint32_t node, float least) {
        int bulges = 0;
        const auto at = [&](int degree) {
            return reliefAt(layouts, node, static_cast<float>(radians(degree)));
        };
        for (int i = 0; i < 360; i += 3) {
            if (at(i) > least && at(i) >= at(i - 3) && at(i) > at(i + 3))
                ++bulges;
        }
        return bulges;
    };
    QVERIFY(bulgesAt(base, 0.15F) >= 3 && bulgesAt(base, 0.15F) <= 7);
    // They end where the flare does.
    QCOMPARE(bulgesAt(nodeOf(layouts, 15), 0.3F), 0);
    QVERIFY(greatestRelief(layouts, base) > 2.0F * greatestRelief(layouts, nodeOf(layouts, 12)));

    TreeParameters parameters = builder.tree.parameters();
    parameters.widths.flare = 0.0;
    builder.apply(parameterChange(builder.tree, parameters));
    QVERIFY(greatestRelief(layoutsOf(builder), base) < 0.5F * greatestRelief(layouts, base));
}

void StrandReliefsTest::lostLimb_leavesAHollowWithARim()
{
    TreeBuilder builder = treeWithLimb(60);
    const InternodeId limb = 31;
    const TreeBuilder never = treeWithLimb(0);
    builder.apply(prune(builder.tree, builder.index, std::span(&limb, 1)));
    QVERIFY(!builder.tree.isAlive(limb));
    const StrandLayouts layouts = layoutsOf(builder);
    const StrandLayouts unhurt = layoutsOf(never);
    const std::uint32_t fork = nodeOf(layouts, kFork);
    const float angle = angleOf(layouts, builder.index, fork, limb);
    const auto change = [&](std::uint32_t node, float turn) {
        return reliefAt(layouts, node, angle + turn) -
               reliefAt(unhurt, nodeOf(unhurt, layouts.skeleton().nodes[node].internode), angle + turn);
    };
    QVERIFY(change(fork, 0.0F) < -0.1F);
    QVERIFY(std::abs(change(fork, static_cast<float>(radians(180)))) < 0.02F);
    float rim = 0.0F;
    for (int degree = 0; degree < 120; ++degree)
        rim = std::max(rim, change(fork, static_cast<float>(radians(degree))));
    QVERIFY2(rim > 0.01F, qPrintable(QString::number(rim)));
    // An index that was made after the loss gives the same hollow.
    const TreeIndex fresh(builder.tree);
    const StrandLayouts again(builder.tree, fresh, Widths(builder.tree, fresh));
    QCOMPARE(reliefAt(again, fork, angle), reliefAt(layouts, fork, angle));
    // Far from it the wood is as it was.
    QVERIFY(std::abs(change(nodeOf(layouts, kFork - 12), 0.0F)) < 0.01F);
    // Undo heals it.
    builder.revert();
    QVERIFY(reliefAt(layoutsOf(builder), fork, angle) > 0.1F);
}

void StrandReliefsTest::lostTwig_leavesNone()
{
    TreeBuilder builder = treeWithLimb(1);
    const InternodeId twig = 31;
    const StrandLayouts before = layoutsOf(builder);
    builder.apply(prune(builder.tree, builder.index, std::span(&twig, 1)));
    const StrandLayouts layouts = layoutsOf(builder);
    const std::uint32_t fork = nodeOf(layouts, kFork);
    for (int degree = 0; degree < 360; ++degree) {
        const auto angle = static_cast<float>(radians(degree));
        QVERIFY(std::abs(reliefAt(layouts, fork, angle) - reliefAt(before, nodeOf(before, kFork), angle)) <
                0.02F);
    }
}

void StrandReliefsTest::hollow_shrinksAsTheWoodThickens()
{
    TreeBuilder builder = treeWithLimb(60, WoodParameters{}.flutes);
    const InternodeId limb = 31;
    builder.apply(prune(builder.tree, builder.index, std::span(&limb, 1)));
    std::vector<float> depths;
    for (int round = 0; round < 4; ++round) {
        const StrandLayouts layouts = layoutsOf(builder);
        const std::uint32_t fork = nodeOf(layouts, kFork);
        const float depth = reliefAt(layouts, fork, angleOf(layouts, builder.index, fork, limb));
        QVERIFY(depth < 0.0F);
        depths.push_back(depth);
        InternodeId top = 30;
        while (builder.index.mainChild(top) != kNoInternode)
            top = builder.index.mainChild(top);
        growBranch(builder, top, kTerminalSlot, continuing(), 150);
    }
    // No hollow is deeper than so much of the radius, so the first two can be as deep.
    QVERIFY(std::ranges::is_sorted(depths));
    QVERIFY(depths.back() < 0.0F && depths.back() > 0.7F * depths.front());
}

void StrandReliefsTest::hollow_isSeenInTheMesh()
{
    TreeBuilder builder = treeWithLimb(20, WoodParameters{}.flutes);
    const InternodeId limb = 31;
    builder.apply(prune(builder.tree, builder.index, std::span(&limb, 1)));
    const StrandLayouts layouts = layoutsOf(builder);
    const StrandNode& fork = layouts.skeleton().nodes[nodeOf(layouts, kFork)];
    const Vec3 outward = outwardOf(builder, limb);
    const float there = barkToward(layouts, builder, fork.position, outward);
    const float opposite = barkToward(layouts, builder, fork.position, -outward);
    QVERIFY(there > 0.0F && opposite > 0.0F);
    QVERIFY2(there < opposite - 0.15F * fork.radius,
             qPrintable(QStringLiteral("%1 %2 %3").arg(there).arg(opposite).arg(fork.radius)));
}

void StrandReliefsTest::hollow_isOnTheLimbsSideOfTwistedWood()
{
    TreeBuilder builder = treeWithLimb(20, WoodParameters{}.flutes);
    const InternodeId limb = 31;
    builder.apply(prune(builder.tree, builder.index, std::span(&limb, 1)));
    for (const float twisted : {0.3F, 0.5F}) {
        for (const InternodeId id : {kFork - 1, kFork, kFork + 1})
            builder.apply(twistChange(builder.tree, id, twisted));
        const StrandLayouts layouts = layoutsOf(builder);
        const StrandNode& fork = layouts.skeleton().nodes[nodeOf(layouts, kFork)];
        const Vec3 outward = outwardOf(builder, limb);
        // Also where the way is half that to the next node.
        for (const float height : {-0.3F, 0.0F, 0.3F}) {
            const Vec3 place = fork.position + height * fork.radius * up();
            const float there = barkToward(layouts, builder, place, outward);
            for (const double degree : {90.0, 180.0, 270.0}) {
                const Vec3 side = Eigen::AngleAxisf(static_cast<float>(radians(degree)), up()) * outward;
                QVERIFY2(there < barkToward(layouts, builder, place, side) - 0.05F * fork.radius,
                         qPrintable(QStringLiteral("%1 at %2, %3°").arg(there).arg(height).arg(degree)));
            }
        }
    }
}

void StrandReliefsTest::hollow_fadesTowardAProfile()
{
    TreeBuilder builder = treeWithLimb(20);
    const InternodeId limb = 31;
    builder.apply(prune(builder.tree, builder.index, std::span(&limb, 1)));
    builder.apply(profileChange(builder.tree, kFork + 1, profileOf(ProfileShape::Round)));
    const StrandLayouts layouts = layoutsOf(builder);
    const std::uint32_t next = nodeOf(layouts, kFork + 1);
    QVERIFY(layouts.reliefs().hasHollow(next));
    const StrandNode& n = layouts.skeleton().nodes[next];
    const Vec3 local = n.frame.conjugate() * outwardOf(builder, limb);
    const Vec2 place = n.radius * Vec2(local.x(), local.z()).normalized();
    const float length = (n.position - layouts.skeleton().nodes[n.parent].position).norm();
    float last = 1.0F;
    for (const float t : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
        const float depth =
            layouts.reliefs().sunk(next, {.t = t, .length = length, .radius = n.radius}, place).norm();
        QVERIFY(depth < last);
        last = depth;
    }
    QCOMPARE(last, 0.0F);
}

void StrandReliefsTest::profile_isShownAsDrawn()
{
    TreeBuilder builder = treeWithLimb(60);
    builder.apply(profileChange(builder.tree, kFork, rectangle(2.0F, 1.0F)));
    const StrandLayouts layouts = layoutsOf(builder);
    QCOMPARE(greatestRelief(layouts, nodeOf(layouts, kFork)), 0.0F);
    // They come back bit by bit where the profile fades.
    float last = 0.0F;
    for (InternodeId id = kFork - 1; layouts.profileScale(nodeOf(layouts, id)) > 0.0F; --id) {
        QVERIFY(greatestRelief(layouts, nodeOf(layouts, id)) > last);
        last = greatestRelief(layouts, nodeOf(layouts, id));
    }
    QVERIFY(greatestRelief(layouts, nodeOf(layouts, kFork - 12)) > 0.0F);
}

void StrandReliefsTest::places_keepTheirOrder()
{
    TreeBuilder builder = treeWithLimb(60);
    const InternodeId limb = 31;
    builder.apply(prune(builder.tree, builder.index, std::span(&limb, 1)));
    const StrandLayouts layouts = layoutsOf(builder);
    QVERIFY(layouts.reliefs().hasHollow(nodeOf(layouts, kFork)));
    for (std::uint32_t node = 0; node < layouts.skeleton().nodes.size(); ++node) {
        const StrandNode& n = layouts.skeleton().nodes[node];
        const float radius = bundleRadius(n.strands);
        const float length = (n.position - layouts.skeleton().nodes[n.parent].position).norm();
        for (int degree = 0; degree < 360; degree += 5) {
            const auto angle = static_cast<float>(radians(degree));
            const Vec2 outward(std::cos(angle), std::sin(angle));
            float last = -1.0F;
            for (int i = 0; i <= 20; ++i) {
                const Vec2 ridged =
                    layouts.reliefs().moved(node, radius * static_cast<float>(i) / 20.0F * outward, radius);
                const Vec2 moved =
                    ridged +
                    layouts.reliefs().sunk(
                        node,
                        {.t = 0.2F * static_cast<float>(degree % 6), .length = length, .radius = radius},
                        ridged);
                // Straight outward, and none passes another.
                QVERIFY(std::abs(moved.x() * outward.y() - moved.y() * outward.x()) < 1e-3F * radius);
                QVERIFY(moved.dot(outward) > last);
                last = moved.dot(outward);
            }
        }
    }
}

const TestClass<StrandReliefsTest> strandReliefsTest;

} // namespace espalier::test

#include "StrandReliefsTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchPropagation.h"

#include "model/sketch/BranchCopy.h"
#include "tests/model/sketch/BranchTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <tuple>

namespace espalier::test {

class BranchPropagationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void equalBranch_getsTheSame();
    void scaling_keepsSharesAndDirections();
    void withoutScaling_distancesFromTheTipStay();
    void targets_areAsAskedFor();
    void replacing_keepsWhatCarriesTheReference();
    void replacing_removesTargetsOnTargets();
    void whatCannotBeDone_isAnError();
};

namespace {

/// A trunk and two limbs of 8 internodes, of @p lengths; the first carries 3 branches of 2 internodes and 2
/// placed leaves.
struct TwoLimbs {
    TreeBuilder builder;
    InternodeId reference;
    InternodeId target;
    std::vector<InternodeId> twigs;

    explicit TwoLimbs(float length, float targetLength)
    {
        builder.growAxis(0, kTerminalSlot, continuing(), 12);
        reference = builder.tree.size();
        builder.growAxis(4, 0, branching(1.0, 0, 2, 0.3), 8, continuing(0.1, 0.4), length);
        target = builder.tree.size();
        builder.growAxis(8, 0, branching(1.2, 1, 2, 2.0), 8, continuing(0.1, 1.4), targetLength);
        for (const InternodeId number : {1U, 4U, 7U}) {
            twigs.push_back(builder.tree.size());
            builder.growAxis(reference + number, 0, branching(0.8, 0, 1), 2, continuing(0.2), 0.05F);
        }
        const std::vector<InternodeId> bearers{reference + 2, reference + 7};
        builder.apply(leafPlacement(builder.tree, bearers));
    }
};

/// A node of a branch with what is there.
struct CarriedNode {
    Vec3 node;
    Vec3 side;
    float along;
    bool operator<(const CarriedNode& other) const
    {
        return std::tuple(node.x(), node.y(), node.z()) <
               std::tuple(other.node.x(), other.node.y(), other.node.z());
    }
};

/// What a branch carries, in a definite order.
std::vector<CarriedNode> carriedBy(const TreeBuilder& builder, InternodeId branch)
{
    std::vector<CarriedNode> carried;
    for (const InternodeId id : internodesOf(builder, branch)) {
        if (builder.index.axis(id) != branch)
            carried.push_back({builder.index.nodePosition(id),
                               builder.index.rotation(id) * Vec3(Vec3::UnitX()),
                               builder.tree.columns().along[id]});
    }
    std::ranges::sort(carried, std::less<>());
    return carried;
}

std::vector<LeafId> livingLeavesOn(const TreeBuilder& builder, InternodeId axis)
{
    std::vector<LeafId> leaves;
    const LeafColumns& c = builder.tree.placedLeaves();
    for (LeafId leaf = 0; leaf < c.size(); ++leaf) {
        if (c.death[leaf] == kNever && builder.tree.isAlive(c.internode[leaf]) &&
            builder.index.axis(c.internode[leaf]) == axis)
            leaves.push_back(leaf);
    }
    return leaves;
}

/// The direction of a leaf in the turtle's frame of its place.
Eigen::Vector3d leafDirection(const TreeBuilder& builder, const BranchAxis& axis, LeafId leaf)
{
    const LeafColumns& c = builder.tree.placedLeaves();
    const auto number = static_cast<std::size_t>(std::ranges::find(axis.internodes(), c.internode[leaf]) -
                                                 axis.internodes().begin());
    const Rotation world = builder.index.rotation(c.internode[leaf]) * c.rotation[leaf];
    return axis.frame(number).conjugate() * (world * Vec3(Vec3::UnitY())).cast<double>();
}

/// Propagates and applies; ends the test if that fails.
void propagate(TreeBuilder& builder, const Propagation& propagation)
{
    Result<TreeDelta> delta = propagated(builder.tree, builder.index, propagation);
    if (!delta)
        qFatal("%s", qPrintable(delta.error().message));
    if (const QString fault = deltaFault(builder, std::move(*delta)); !fault.isEmpty())
        qFatal("%s", qPrintable(fault));
}

Propagation toOne(InternodeId reference, InternodeId target, bool scaling = true, bool replaces = false)
{
    return {.reference = reference,
            .targets = Propagation::Targets::Listed,
            .axes = {target},
            .scaling = scaling,
            .replaces = replaces};
}

std::uint32_t orderOf(const Tree& tree, InternodeId id)
{
    std::uint32_t order = 0;
    for (; !tree.isRoot(id); id = tree.parent(id))
        order += tree.continuesAxis(id) ? 0U : 1U;
    return order;
}

} // namespace

void BranchPropagationTest::equalBranch_getsTheSame()
{
    int tried = 0;
    for (TreeBuilder& builder : branchTrees()) {
        for (const InternodeId reference : branchesOf(builder)) {
            if (childrenOf(builder, reference).empty())
                continue;
            // The same branch elsewhere, then without what it carries, then with copies of that.
            BranchCopies copies(builder.tree, builder.index);
            const InternodeId equal =
                copies.add(reference, {.parent = builder.tree.parent(reference),
                                       .along = 0.4F,
                                       .rotation = builder.tree.columns().rotation[reference],
                                       .scale = 1.0});
            Result<TreeDelta> delta = copies.finish();
            QVERIFY(delta);
            builder.apply(std::move(*delta));
            const std::vector<CarriedNode> before = carriedBy(builder, equal);
            const std::size_t leaves = livingLeavesOn(builder, equal).size();
            for (const bool scaling : {true, false}) {
                propagate(builder, toOne(reference, equal, scaling, true));
                const std::vector<CarriedNode> after = carriedBy(builder, equal);
                QCOMPARE(after.size(), before.size());
                for (std::size_t i = 0; i < after.size(); ++i) {
                    QVERIFY((after[i].node - before[i].node).norm() < 1e-5F);
                    QVERIFY((after[i].side - before[i].side).norm() < 1e-4F);
                    QVERIFY(std::abs(after[i].along - before[i].along) < 1e-4F);
                }
                QCOMPARE(livingLeavesOn(builder, equal).size(), leaves);
                builder.revert();
                ++tried;
            }
            builder.revert();
        }
    }
    QVERIFY(tried > 80);
}

void BranchPropagationTest::scaling_keepsSharesAndDirections()
{
    TwoLimbs limbs(0.1F, 0.025F);
    TreeBuilder& builder = limbs.builder;
    propagate(builder, toOne(limbs.reference + 3, limbs.target + 5));
    const BranchAxis from(builder.tree, builder.index, limbs.reference);
    const BranchAxis to(builder.tree, builder.index, limbs.target);
    const std::vector<ChildBranch> originals = childrenOf(builder, limbs.reference);
    const std::vector<ChildBranch> copies = childrenOf(builder, limbs.target);
    QCOMPARE(originals.size(), std::size_t{3});
    QCOMPARE(copies.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(std::abs(copies[i].distance - 0.25 * originals[i].distance) < 1e-6);
        QVERIFY((copies[i].heading - originals[i].heading).norm() < 1e-5);
        QCOMPARE(copies[i].place.number, originals[i].place.number);
        QCOMPARE(copies[i].place.along, 1.0F);
        QVERIFY(std::abs(BranchAxis(builder.tree, builder.index, copies[i].id).length() - 0.025) < 1e-6);
    }
    const std::vector<LeafId> leaves = livingLeavesOn(builder, limbs.reference);
    const std::vector<LeafId> copied = livingLeavesOn(builder, limbs.target);
    QCOMPARE(copied.size(), std::size_t{2});
    const LeafColumns& c = builder.tree.placedLeaves();
    for (std::size_t i = 0; i < 2; ++i) {
        QVERIFY(std::abs(c.length[copied[i]] - 0.25F * c.length[leaves[i]]) < 1e-7F);
        QCOMPARE(c.internode[copied[i]] - limbs.target, c.internode[leaves[i]] - limbs.reference);
        QVERIFY(std::abs(c.along[copied[i]] - c.along[leaves[i]]) < 1e-5F);
        QVERIFY((leafDirection(builder, to, copied[i]) - leafDirection(builder, from, leaves[i])).norm() <
                1e-5);
    }
}

void BranchPropagationTest::withoutScaling_distancesFromTheTipStay()
{
    // The target has half the length: the lowest branch and the lower leaf are left out.
    TwoLimbs limbs(0.1F, 0.05F);
    TreeBuilder& builder = limbs.builder;
    propagate(builder, toOne(limbs.reference, limbs.target, false));
    const std::vector<ChildBranch> originals = childrenOf(builder, limbs.reference);
    const std::vector<ChildBranch> copies = childrenOf(builder, limbs.target);
    QCOMPARE(copies.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i) {
        const ChildBranch& original = originals[i + 1];
        QVERIFY(std::abs((0.4 - copies[i].distance) - (0.8 - original.distance)) < 1e-6);
        QVERIFY((copies[i].heading - original.heading).norm() < 1e-5);
        QVERIFY(std::abs(BranchAxis(builder.tree, builder.index, copies[i].id).length() - 0.1) < 1e-6);
    }
    const std::vector<LeafId> copied = livingLeavesOn(builder, limbs.target);
    QCOMPARE(copied.size(), std::size_t{1});
    QCOMPARE(builder.tree.placedLeaves().length[copied[0]], 0.08F);
}

void BranchPropagationTest::targets_areAsAskedFor()
{
    int tried = 0;
    for (TreeBuilder& builder : branchTrees()) {
        const std::vector<InternodeId> branches = branchesOf(builder);
        for (const auto targets : {Propagation::Targets::All, Propagation::Targets::SameOrder}) {
            const auto found = std::ranges::find_if(branches, [&](InternodeId id) {
                return !childrenOf(builder, id).empty() && orderOf(builder.tree, id) == 1;
            });
            QVERIFY(found != branches.end());
            const InternodeId reference = *found;
            const std::size_t given = childrenOf(builder, reference).size();
            const std::vector<InternodeId> onReference = internodesOf(builder, reference);
            std::vector<std::size_t> before;
            for (const InternodeId id : branches)
                before.push_back(childrenOf(builder, id).size());
            const std::size_t onTrunk = childrenOf(builder, 0).size();
            const auto isTarget = [&](InternodeId id) {
                return std::ranges::count(onReference, id) == 0 &&
                       (targets == Propagation::Targets::All || orderOf(builder.tree, id) == 1);
            };
            if (std::ranges::none_of(branches, isTarget)) {
                QCOMPARE(messageOf(propagated(builder.tree, builder.index,
                                              {.reference = reference, .targets = targets, .axes = {}})),
                         QStringLiteral("there is no other branch to copy to"));
                continue;
            }
            propagate(builder, {.reference = reference, .targets = targets, .axes = {}});
            for (std::size_t i = 0; i < branches.size(); ++i) {
                QCOMPARE(childrenOf(builder, branches[i]).size(),
                         before[i] + (isTarget(branches[i]) ? given : 0));
            }
            tried += static_cast<int>(std::ranges::count_if(branches, isTarget));
            QCOMPARE(childrenOf(builder, 0).size(), onTrunk);
            builder.revert();
        }
        // The trunk, and what the reference carries, if they are listed; the reference never.
        const auto found =
            std::ranges::find_if(branches, [&](InternodeId id) { return !childrenOf(builder, id).empty(); });
        const InternodeId reference = *found;
        const std::vector<ChildBranch> carried = childrenOf(builder, reference);
        const std::size_t onTrunk = childrenOf(builder, 0).size();
        const std::size_t onFirst = childrenOf(builder, carried[0].id).size();
        propagate(builder, {.reference = reference,
                            .targets = Propagation::Targets::Listed,
                            .axes = {0, carried[0].id, reference, 0, 100'000}});
        QCOMPARE(childrenOf(builder, 0).size(), onTrunk + carried.size());
        QCOMPARE(childrenOf(builder, carried[0].id).size(), onFirst + carried.size());
        QCOMPARE(childrenOf(builder, reference).size(), carried.size());
    }
    QVERIFY(tried > 50);
}

void BranchPropagationTest::replacing_keepsWhatCarriesTheReference()
{
    TwoLimbs limbs(0.1F, 0.1F);
    TreeBuilder& builder = limbs.builder;
    // A twig of the reference becomes an example; the limb that carries it is a target, too.
    const InternodeId twig = limbs.twigs[1];
    builder.growAxis(twig, 0, branching(1.0), 2);
    const InternodeId needle = builder.tree.size() - 2;
    propagate(builder, {.reference = twig,
                        .targets = Propagation::Targets::All,
                        .axes = {},
                        .scaling = true,
                        .replaces = true});
    QVERIFY(builder.tree.isAlive(twig));
    QVERIFY(builder.tree.isAlive(needle));
    QVERIFY(!builder.tree.isAlive(limbs.twigs[0]));
    QVERIFY(!builder.tree.isAlive(limbs.twigs[2]));
    QCOMPARE(childrenOf(builder, limbs.reference).size(), std::size_t{2});
    QCOMPARE(childrenOf(builder, limbs.target).size(), std::size_t{1});
    QVERIFY(livingLeavesOn(builder, limbs.reference).empty());
}

void BranchPropagationTest::replacing_removesTargetsOnTargets()
{
    TwoLimbs limbs(0.1F, 0.1F);
    TreeBuilder& builder = limbs.builder;
    builder.growAxis(limbs.target + 2, 0, branching(1.0), 3);
    const InternodeId old = builder.tree.size() - 3;
    propagate(builder, {.reference = limbs.reference,
                        .targets = Propagation::Targets::All,
                        .axes = {},
                        .scaling = true,
                        .replaces = true});
    QVERIFY(!builder.tree.isAlive(old));
    QVERIFY(!builder.tree.isAlive(old + 2));
    QCOMPARE(childrenOf(builder, limbs.target).size(), std::size_t{3});
    QCOMPARE(childrenOf(builder, limbs.reference).size(), std::size_t{3});
}

void BranchPropagationTest::whatCannotBeDone_isAnError()
{
    TwoLimbs limbs(0.1F, 0.1F);
    TreeBuilder& builder = limbs.builder;
    const auto fault = [&](const Propagation& propagation) {
        return messageOf(propagated(builder.tree, builder.index, propagation));
    };
    QCOMPARE(fault({.reference = 9999, .axes = {}}), QStringLiteral("internode 9999 is not alive"));
    QCOMPARE(fault({.reference = limbs.twigs[0], .axes = {}}),
             QStringLiteral("the branch of internode %1 carries nothing to copy").arg(limbs.twigs[0]));
    // All others are on the trunk.
    QCOMPARE(fault({.reference = 0, .axes = {}}), QStringLiteral("there is no other branch to copy to"));
    QCOMPARE(fault(toOne(limbs.reference, limbs.reference + 1)),
             QStringLiteral("there is no other branch to copy to"));
    builder.growAxis(9, 0, branching(1.0), 1, continuing(), 0.01F);
    const InternodeId stub = builder.tree.size() - 1;
    builder.apply(leafRemoval(builder.tree, 1));
    builder.apply(death(builder.tree, builder.index, limbs.twigs[2]));
    QCOMPARE(fault(toOne(limbs.reference, stub, false)),
             QStringLiteral("all other branches are too short for what the branch of internode %1 carries")
                 .arg(limbs.reference));
}

static const TestClass<BranchPropagationTest> branchPropagationTest;

} // namespace espalier::test

#include "BranchPropagationTest.moc"

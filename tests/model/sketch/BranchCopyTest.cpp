// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchCopy.h"

#include "tests/model/sketch/BranchTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <bit>

namespace espalier::test {

class BranchCopyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void copy_isTheBranchTurnedMovedAndScaled();
    void copies_canStandOnCopies();
    void crowdedNode_givesEachCopySlotAndKey();
    void removedBranch_diesWhole();
    void nothing_isNoStep();
    void limits_areKept();
};

namespace {

const Rotation kTurned(Eigen::AngleAxisf(0.7F, Vec3(0.6F, 0.0F, 0.8F)));

/// What differs between a branch of the internodes @p from and its copy; empty if nothing.
QString copyFault(const TreeBuilder& builder, const std::vector<InternodeId>& from, InternodeId copy,
                  double scale)
{
    const InternodeId source = from.front();
    const Tree& tree = builder.tree;
    const InternodeColumns& c = tree.columns();
    const SparseColumns& sparse = tree.content().sparse;
    const std::vector<InternodeId> to = internodesOf(builder, copy);
    if (from.size() != to.size())
        return QStringLiteral("%1 internodes of %2").arg(to.size()).arg(from.size());
    const auto isScaled = [scale](float original, float scaled) {
        return std::abs(scale * double{original} - double{scaled}) <= 1e-6 * (1e-3 + double{scaled});
    };
    // The first internode turns the rest with it.
    const Vec3 base = builder.index.basePosition(tree, source);
    const Vec3 newBase = builder.index.basePosition(tree, copy);
    const Rotation turn = builder.index.rotation(copy) * builder.index.rotation(source).conjugate();
    for (std::size_t i = 0; i < from.size(); ++i) {
        const InternodeId a = from[i];
        const InternodeId b = to[i];
        const bool isFirst = i == 0;
        if (!isFirst &&
            (c.rotation[a] != c.rotation[b] || c.along[a] != c.along[b] || c.slot[a] != c.slot[b]))
            return QStringLiteral("the place of internode %1").arg(a);
        if (!isScaled(c.length[a], c.length[b]) || c.buds[a] != c.buds[b] || c.vigour[a] != c.vigour[b] ||
            c.parameterSet[a] != c.parameterSet[b] || c.birth[b] != tree.step())
            return QStringLiteral("a column of internode %1").arg(a);
        if (sparse.twist.at(a) != sparse.twist.at(b) || sparse.profile.at(a) != sparse.profile.at(b) ||
            !isScaled(tree.widthConstraint(a), tree.widthConstraint(b)) ||
            !isScaled(tree.clearLength(a), tree.clearLength(b)))
            return QStringLiteral("a sparse column of internode %1").arg(a);
        const Vec3 expected =
            newBase + static_cast<float>(scale) * (turn * Vec3(builder.index.nodePosition(a) - base));
        if ((expected - builder.index.nodePosition(b)).norm() > 2e-5F)
            return QStringLiteral("the node of internode %1").arg(a);
    }
    const LeafColumns& leaves = tree.placedLeaves();
    const auto leavesOn = [&](InternodeId id) {
        std::vector<LeafId> found;
        for (LeafId leaf = 0; leaf < leaves.size(); ++leaf) {
            if (leaves.internode[leaf] == id && leaves.death[leaf] == kNever)
                found.push_back(leaf);
        }
        return found;
    };
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::vector<LeafId> a = leavesOn(from[i]);
        const std::vector<LeafId> b = leavesOn(to[i]);
        if (a.size() != b.size())
            return QStringLiteral("the number of leaves of internode %1").arg(from[i]);
        for (std::size_t j = 0; j < a.size(); ++j) {
            if (leaves.along[a[j]] != leaves.along[b[j]] || leaves.rotation[a[j]] != leaves.rotation[b[j]] ||
                leaves.kind[a[j]] != leaves.kind[b[j]] || !isScaled(leaves.length[a[j]], leaves.length[b[j]]))
                return QStringLiteral("leaf %1").arg(a[j]);
        }
    }
    return {};
}

} // namespace

void BranchCopyTest::copy_isTheBranchTurnedMovedAndScaled()
{
    std::size_t leaves = 0;
    for (TreeBuilder& builder : branchTrees()) {
        for (const double scale : {1.0, 0.4, 2.5}) {
            const std::vector<InternodeId> branches = branchesOf(builder);
            // The branch that carries most, and one that begins where others do.
            const InternodeId source =
                std::ranges::max(branches, {}, [&](InternodeId id) { return builder.index.subtreeSize(id); });
            const std::vector<InternodeId> original = internodesOf(builder, source);
            BranchCopies copies(builder.tree, builder.index);
            const InternodeId parent = builder.tree.parent(branches[branches.size() / 2]);
            const InternodeId copy =
                copies.add(source, {.parent = parent, .along = 0.3F, .rotation = kTurned, .scale = scale});
            Result<TreeDelta> delta = copies.finish();
            QVERIFY2(delta, qPrintable(messageOf(delta)));
            leaves += delta->bornLeaves.count;
            QCOMPARE(delta->stepAfter, builder.tree.step() + 1);
            QCOMPARE(copy, builder.tree.size());
            QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
            QCOMPARE(builder.tree.parent(copy), parent);
            QCOMPARE(builder.tree.columns().along[copy], 0.3F);
            QCOMPARE(copyFault(builder, original, copy, scale), QString());
            QCOMPARE(builder.index.axis(copy), copy);
        }
    }
    QVERIFY(leaves > 20);
}

void BranchCopyTest::copies_canStandOnCopies()
{
    TreeBuilder builder = treeOfDrawing(4, 20);
    const std::vector<InternodeId> branches = branchesOf(builder);
    const InternodeId source = branches[1];
    const std::vector<InternodeId> original = internodesOf(builder, source);
    BranchCopies copies(builder.tree, builder.index);
    InternodeId parent = builder.tree.parent(branches[0]);
    std::vector<InternodeId> made;
    for (int i = 0; i < 20; ++i) {
        made.push_back(
            copies.add(source, {.parent = parent, .along = 0.5F, .rotation = kTurned, .scale = 0.9}));
        parent = made.back();
    }
    Result<TreeDelta> delta = copies.finish();
    QVERIFY2(delta, qPrintable(messageOf(delta)));
    QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
    for (std::size_t i = 1; i < made.size(); ++i) {
        QCOMPARE(builder.tree.parent(made[i]), made[i - 1]);
        QCOMPARE(builder.index.axis(made[i]), made[i]);
    }
    // It carries nothing but what the original carries.
    QCOMPARE(copyFault(builder, original, made.back(), 0.9), QString());
}

void BranchCopyTest::crowdedNode_givesEachCopySlotAndKey()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 3);
    builder.growAxis(1, 0, branching(1.0), 2);
    const InternodeId source = builder.tree.size() - 2;
    // Twice, with a prune between, at the same step of time.
    for (int round = 0; round < 2; ++round) {
        BranchCopies copies(builder.tree, builder.index);
        std::vector<InternodeId> made;
        for (int i = 0; i < 30; ++i)
            made.push_back(
                copies.add(source, {.parent = 2, .along = 0.5F, .rotation = kTurned, .scale = 1.0}));
        Result<TreeDelta> delta = copies.finish();
        QVERIFY(delta);
        // treeFault() compares the keys.
        QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
        BudMask slots = 0;
        for (const InternodeId id : made) {
            const int slot = builder.tree.columns().slot[id];
            QVERIFY(slot != kTerminalSlot);
            // A bud stays.
            QCOMPARE(builder.tree.budStates(2).state(slot), BudState::None);
            slots = static_cast<BudMask>(slots | budBit(slot));
        }
        // All but those of the buds, of the seats that do not exist, and of the tip.
        const int laterals = builder.tree.parameters().growth.lateralsPerNode;
        QCOMPARE(std::popcount(slots), kMaxLaterals - laterals + kBudSlots - kFirstAdventitiousSlot);
        TreeDelta pruned = deltaStartingAt(builder.tree);
        for (const InternodeId id : made) {
            pruned.died.push_back(id);
            pruned.died.push_back(builder.index.firstChild(id));
        }
        builder.apply(std::move(pruned));
    }
}

void BranchCopyTest::removedBranch_diesWhole()
{
    for (TreeBuilder& builder : branchTrees()) {
        const std::vector<InternodeId> branches = branchesOf(builder);
        const InternodeId gone = branches[branches.size() / 3];
        std::vector<InternodeId> all = internodesOf(builder, gone);
        std::ranges::sort(all);
        BranchCopies copies(builder.tree, builder.index);
        copies.remove(all.back());
        copies.remove(gone);
        copies.remove(gone);
        QVERIFY(copies.isRemoved(gone));
        QVERIFY(!copies.isRemoved(0));
        Result<TreeDelta> delta = copies.finish();
        QVERIFY(delta);
        QCOMPARE(delta->died, all);
        QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
        QVERIFY(!builder.tree.isAlive(gone));
    }
}

void BranchCopyTest::nothing_isNoStep()
{
    const TreeBuilder builder = randomTree(50);
    Result<TreeDelta> delta = BranchCopies(builder.tree, builder.index).finish();
    QVERIFY(delta);
    QVERIFY(delta->isEmpty());
}

void BranchCopyTest::limits_areKept()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 3);
    builder.growAxis(1, 0, branching(1.0), 4);
    const InternodeId source = builder.tree.size() - 4;
    builder.apply(widthChange(builder.tree, source, 0.01F));
    builder.apply(leafPlacement(builder.tree, std::span(&source, 1)));
    {
        BranchCopies copies(builder.tree, builder.index);
        const InternodeId copy =
            copies.add(source, {.parent = 1, .along = 1.0F, .rotation = kTurned, .scale = 1e6});
        Result<TreeDelta> delta = copies.finish();
        QVERIFY(delta);
        QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
        QCOMPARE(builder.tree.length(copy), kGreatestLength);
        QCOMPARE(builder.tree.widthConstraint(copy), kGreatestDiameter);
        QCOMPARE(builder.tree.placedLeaves().length[1], kGreatestLeaf);
        builder.revert();
    }
    {
        BranchCopies copies(builder.tree, builder.index);
        const InternodeId copy =
            copies.add(source, {.parent = 1, .along = 1.0F, .rotation = kTurned, .scale = 1e-20});
        Result<TreeDelta> delta = copies.finish();
        QVERIFY(delta);
        QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
        QCOMPARE(builder.tree.length(copy), 1e-6F);
        builder.revert();
    }
    {
        BranchCopies copies(builder.tree, builder.index);
        InternodeId parent = 1;
        for (int i = 0; i < 20; ++i)
            parent = copies.add(
                source, {.parent = parent, .along = 1.0F, .rotation = Rotation::Identity(), .scale = 1e6});
        const Result<TreeDelta> delta = copies.finish();
        QVERIFY(!delta);
        QCOMPARE(messageOf(delta), QStringLiteral("a copy would reach more than 10000 m away"));
    }
    {
        BranchCopies copies(builder.tree, builder.index);
        for (std::uint32_t i = 0; i <= BranchCopies::kMost / 4; ++i)
            copies.add(source, {.parent = 1, .along = 1.0F, .rotation = kTurned, .scale = 1.0});
        const Result<TreeDelta> delta = copies.finish();
        QVERIFY(!delta);
        QCOMPARE(messageOf(delta), QStringLiteral("the copies would have more than 1000000 internodes"));
    }
}

static const TestClass<BranchCopyTest> branchCopyTest;

} // namespace espalier::test

#include "BranchCopyTest.moc"

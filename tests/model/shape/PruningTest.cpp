// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Pruning.h"

#include "model/shape/Widths.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <array>
#include <set>

namespace espalier::test {

class PruningTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cut_isAtTheBranchingPointBelow();
    void cut_isJustAboveAWidthConstraint();
    void prune_takesWhatTheCutsCarryAndNoMore();
    void prune_ofNothingIsEmpty();
    void widths_becomeAsIfTheBranchHadNeverBeen();
    void stub_keepsItsWidthByAConstraint();
};

namespace {

/// A trunk 1…6, and a branch 7…9 from the node of internode 3.
TreeBuilder fork()
{
    TreeBuilder builder;
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < 6; ++i)
        internodes.push_back({.parent = i});
    internodes.push_back({.parent = 3, .slot = 0, .rotation = branching(1.0)});
    internodes.push_back({.parent = 7});
    internodes.push_back({.parent = 8});
    builder.apply(births(builder.tree, internodes));
    return builder;
}

} // namespace

void PruningTest::cut_isAtTheBranchingPointBelow()
{
    const TreeBuilder builder = fork();
    QCOMPARE(cutBelow(builder.tree, builder.index, 9), 7U);
    QCOMPARE(cutBelow(builder.tree, builder.index, 7), 7U);
    QCOMPARE(cutBelow(builder.tree, builder.index, 6), 4U);
    QCOMPARE(cutBelow(builder.tree, builder.index, 3), 1U);
    QCOMPARE(cutBelow(builder.tree, builder.index, 0), kNoInternode);
}

void PruningTest::cut_isJustAboveAWidthConstraint()
{
    TreeBuilder builder = fork();
    builder.apply(widthChange(builder.tree, 7, 0.02F));
    QCOMPARE(cutBelow(builder.tree, builder.index, 9), 8U);
    QCOMPARE(cutBelow(builder.tree, builder.index, 7), 7U);
}

void PruningTest::prune_takesWhatTheCutsCarryAndNoMore()
{
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        TreeBuilder builder = randomTree(300, seed);
        Random random(seed, 0, 0, Purpose::Direction);
        std::vector<InternodeId> cuts;
        for (int i = 0; i < 5; ++i)
            cuts.push_back(1 + static_cast<InternodeId>(random.bits() % (builder.tree.size() + 20)));
        std::set<InternodeId> expected;
        for (InternodeId id = 1; id < builder.tree.size(); ++id) {
            for (InternodeId below = id; below != 0; below = builder.tree.parent(below)) {
                if (builder.tree.isAlive(id) && std::ranges::count(cuts, below) != 0)
                    expected.insert(id);
            }
        }
        const Tree before = builder.tree;
        const TreeDelta& delta = builder.apply(prune(builder.tree, builder.index, cuts));
        QVERIFY(std::ranges::equal(delta.died, expected));
        QVERIFY(delta.internodes.buds.empty() && delta.born.count == 0);
        builder.revert();
        QVERIFY(builder.tree == before);
    }
}

void PruningTest::prune_ofNothingIsEmpty()
{
    TreeBuilder builder = fork();
    QVERIFY(prune(builder.tree, builder.index, {}).isEmpty());
    QVERIFY(prune(builder.tree, builder.index, std::array{InternodeId{0}, InternodeId{500}}).isEmpty());
    builder.apply(prune(builder.tree, builder.index, std::array{InternodeId{8}}));
    QVERIFY(prune(builder.tree, builder.index, std::array{InternodeId{8}, InternodeId{9}}).isEmpty());
}

void PruningTest::widths_becomeAsIfTheBranchHadNeverBeen()
{
    TreeBuilder builder = fork();
    builder.apply(prune(builder.tree, builder.index, std::array{InternodeId{7}}));
    const Widths widths(builder.tree, builder.index);
    for (InternodeId id = 0; id <= 6; ++id)
        QCOMPARE(widths.radius(builder.index, id), widths.radiusOfTips(1));
}

void PruningTest::stub_keepsItsWidthByAConstraint()
{
    TreeBuilder builder = fork();
    builder.apply(widthChange(builder.tree, 7, 0.02F));
    const float below = Widths(builder.tree, builder.index).radius(builder.index, 3);
    builder.apply(prune(builder.tree, builder.index, std::array{cutBelow(builder.tree, builder.index, 9)}));
    const Widths widths(builder.tree, builder.index);
    QVERIFY(builder.tree.isAlive(7));
    QCOMPARE(widths.radius(builder.index, 7), 0.01F);
    QCOMPARE(widths.radius(builder.index, 3), below);
}

const TestClass<PruningTest> pruningTest;

} // namespace espalier::test

#include "PruningTest.moc"

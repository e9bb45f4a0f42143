// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/ClearWood.h"

#include "tests/support/PlacedLeaves.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <array>

namespace espalier::test {

class ClearWoodTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void clear_takesTheShootsBelowAndNoOthers();
    void clear_letsBudsRestBelowAndNowhereElse();
    void clear_takesPlacedLeavesThere();
    void shorter_wakesTheBudsBeyond();
    void none_wakesAllAndForgetsTheLength();
    void branch_isKeptClearByItself();
    void same_isEmpty();
    void deadOrUnknown_isEmpty();
};

namespace {

/// A trunk 0…6 of internodes of 0.1 m; branches at the nodes of 1 (7, 8), of 3 (9, 10) and of 5 (11); and a
/// twig 12 on 9.
TreeBuilder trunkWithBranches()
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    parameters.growth.lateralsPerNode = 2;
    TreeBuilder builder(1, parameters);
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < 6; ++i)
        internodes.push_back({.parent = i});
    for (const InternodeId parent : {1U, 3U}) {
        internodes.push_back({.parent = parent, .slot = 0, .rotation = branching(1.0)});
        internodes.push_back({.parent = static_cast<InternodeId>(internodes.size())});
    }
    internodes.push_back({.parent = 5, .slot = 0, .rotation = branching(1.0)});
    internodes.push_back({.parent = 9, .slot = 0, .rotation = branching(1.0)});
    builder.apply(births(builder.tree, internodes));
    return builder;
}

BudMask lateralsOf(const Tree& tree, InternodeId id)
{
    return static_cast<BudMask>(tree.buds(id) & ~kTerminalBud);
}

} // namespace

void ClearWoodTest::clear_takesTheShootsBelowAndNoOthers()
{
    TreeBuilder builder = trunkWithBranches();
    QCOMPARE(shootsBelow(builder.tree, builder.index, 4, 0.35F), (std::vector<InternodeId>{7}));
    // The branch at the node of internode 3 is attached at 0.4 m.
    QCOMPARE(shootsBelow(builder.tree, builder.index, 0, 0.45F), (std::vector<InternodeId>{7, 9}));
    const TreeDelta delta = keepClear(builder.tree, builder.index, 4, 0.45F);
    QCOMPARE(delta.died, (std::vector<InternodeId>{7, 8, 9, 10, 12}));
    builder.apply(delta);
    QCOMPARE(builder.tree.clearLength(0), 0.45F);
    QVERIFY(builder.tree.isAlive(11));
}

void ClearWoodTest::clear_letsBudsRestBelowAndNowhereElse()
{
    TreeBuilder builder = trunkWithBranches();
    builder.apply(keepClear(builder.tree, builder.index, 0, 0.45F));
    for (InternodeId id = 1; id <= 3; ++id) {
        QCOMPARE(lateralsOf(builder.tree, id), BudMask{0});
        QCOMPARE(builder.tree.budStates(id).state(1), BudState::Dormant);
    }
    QVERIFY(lateralsOf(builder.tree, 4) != 0);
    QVERIFY(lateralsOf(builder.tree, 5) != 0);
    // The tip goes on growing.
    QVERIFY((builder.tree.buds(6) & kTerminalBud) != 0);
    QVERIFY(lateralsOf(builder.tree, 11) != 0);
}

void ClearWoodTest::clear_takesPlacedLeavesThere()
{
    TreeBuilder builder = trunkWithBranches();
    builder.apply(leafPlacement(builder.tree, std::array<InternodeId, 3>{1, 5, 8}));
    const TreeDelta delta = keepClear(builder.tree, builder.index, 0, 0.35F);
    QCOMPARE(delta.leaves.death.size(), std::size_t{1});
    QCOMPARE(builder.tree.placedLeaves().internode[delta.leaves.death.front().row], 1U);
}

void ClearWoodTest::shorter_wakesTheBudsBeyond()
{
    TreeBuilder builder = trunkWithBranches();
    builder.apply(keepClear(builder.tree, builder.index, 0, 0.65F));
    builder.apply(keepClear(builder.tree, builder.index, 0, 0.25F));
    QCOMPARE(lateralsOf(builder.tree, 1), BudMask{0});
    QVERIFY(lateralsOf(builder.tree, 2) != 0);
    QVERIFY(lateralsOf(builder.tree, 5) != 0);
    // What went has gone.
    QVERIFY(!builder.tree.isAlive(11));
}

void ClearWoodTest::none_wakesAllAndForgetsTheLength()
{
    TreeBuilder builder = trunkWithBranches();
    builder.apply(keepClear(builder.tree, builder.index, 0, 0.65F));
    builder.apply(keepClear(builder.tree, builder.index, 2, 0.0F));
    QVERIFY(builder.tree.content().sparse.clearLength.cells().empty());
    for (InternodeId id = 1; id <= 6; ++id)
        QVERIFY(lateralsOf(builder.tree, id) != 0);
}

void ClearWoodTest::branch_isKeptClearByItself()
{
    TreeBuilder builder = trunkWithBranches();
    builder.apply(keepClear(builder.tree, builder.index, 10, 0.15F));
    QCOMPARE(builder.tree.clearLength(9), 0.15F);
    QVERIFY(!builder.tree.isAlive(12));
    QCOMPARE(lateralsOf(builder.tree, 9), BudMask{0});
    QVERIFY(lateralsOf(builder.tree, 10) != 0);
    QVERIFY(lateralsOf(builder.tree, 1) != 0);
}

void ClearWoodTest::same_isEmpty()
{
    TreeBuilder builder = trunkWithBranches();
    QVERIFY(keepClear(builder.tree, builder.index, 0, 0.0F).isEmpty());
    builder.apply(keepClear(builder.tree, builder.index, 0, 0.45F));
    QVERIFY(keepClear(builder.tree, builder.index, 3, 0.45F).isEmpty());
}

void ClearWoodTest::deadOrUnknown_isEmpty()
{
    TreeBuilder builder = trunkWithBranches();
    builder.apply(death(builder.tree, builder.index, 9));
    for (const InternodeId id : {InternodeId{9}, InternodeId{700}})
        QVERIFY(keepClear(builder.tree, builder.index, id, 0.5F).isEmpty());
}

static const TestClass<ClearWoodTest> clearWoodTest;

} // namespace espalier::test

#include "ClearWoodTest.moc"

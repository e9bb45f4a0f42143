// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/Tree.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QtTest>

#include <cmath>

namespace espalier::test {

class TreeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void newTree_isAnUprightSeedling();
    void revert_restoresWhatApplyChanged();
    void applyAgain_bringsBackTheSameTree();
    void copies_doNotShareWhatChanges();
    void death_leavesRowsAndRevertRevives();
    void absentRows_liveAgainWhenTheirBirthIsRedone();
    void rememberedParameters_areKnownOnce();
    void forgottenParameters_areGone();
    void parameterChange_leavesWhatHasGrown();
    void fromColumns_acceptsWhatATreeHolds();
    void fromColumns_refusesFaults_data();
    void fromColumns_refusesFaults();
    void emptyDelta_isEmpty();
};

namespace {

Result<Tree> reread(const Tree& tree, InternodeColumns columns)
{
    return Tree::fromColumns(tree.seed(), tree.step(), std::move(columns), tree.parameterSets(),
                             tree.currentParameterSet());
}

/// The two trees look alike: @p after may hold more rows and parameters, but only absent and unused ones.
bool looksLike(const Tree& after, const Tree& before)
{
    if (after.step() != before.step() || after.parameters() != before.parameters())
        return false;
    for (InternodeId id = 0; id < after.size(); ++id) {
        if (id >= before.size()
                ? after.isAlive(id)
                : after.isAlive(id) != before.isAlive(id) || after.buds(id) != before.buds(id) ||
                      after.columns().death[id] != before.columns().death[id])
            return false;
    }
    return true;
}

} // namespace

void TreeTest::newTree_isAnUprightSeedling()
{
    const Tree tree(7);
    QCOMPARE(tree.size(), 1U);
    QVERIFY(tree.isAlive(0));
    QCOMPARE(tree.parent(0), kNoInternode);
    QCOMPARE(tree.buds(0), kTerminalBud);
    QCOMPARE(tree.seed(), std::uint64_t{7});
    QCOMPARE(tree.step(), 0U);
    const TreeIndex index(tree);
    QVERIFY((index.heading(0) - up()).norm() < 1e-6F);
    QVERIFY(
        (index.nodePosition(0) - static_cast<float>(tree.parameters().growth.internodeLength) * up()).norm() <
        1e-6F);
}

void TreeTest::revert_restoresWhatApplyChanged()
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        TreeBuilder builder = randomTree(200, seed);
        std::vector<Tree> before;
        for (int i = 0; i < 5; ++i) {
            before.push_back(builder.tree);
            InternodeId victim = 50;
            while (!builder.tree.isAlive(victim))
                ++victim;
            builder.apply(i % 2 == 0 ? randomGrowth(builder.tree, 30, seed)
                                     : death(builder.tree, builder.index, victim));
        }
        while (!before.empty()) {
            builder.revert();
            QVERIFY(looksLike(builder.tree, before.back()));
            before.pop_back();
        }
    }
}

void TreeTest::applyAgain_bringsBackTheSameTree()
{
    TreeBuilder builder = randomTree(300, 3);
    const Tree done = builder.tree;
    std::vector<TreeDelta> taken;
    while (!builder.journal.empty())
        taken.push_back(builder.revert());
    QVERIFY(!(builder.tree == done));
    QCOMPARE(TreeIndex(builder.tree).livingCount(), 1U);
    const Tree undone = builder.tree;
    for (int round = 0; round < 2; ++round) {
        while (!taken.empty()) {
            builder.apply(std::move(taken.back()));
            taken.pop_back();
        }
        QVERIFY(builder.tree == done);
        while (!builder.journal.empty())
            taken.push_back(builder.revert());
        QVERIFY(builder.tree == undone);
    }
}

void TreeTest::copies_doNotShareWhatChanges()
{
    TreeBuilder builder = randomTree(100, 4);
    const Tree snapshot = builder.tree;
    const Tree same = snapshot;
    builder.apply(death(builder.tree, builder.index, 40));
    builder.apply(randomGrowth(builder.tree, 20, 4));
    QVERIFY(snapshot == same);
    QCOMPARE(snapshot.size(), 100U);
    QVERIFY(snapshot.isAlive(40));
}

void TreeTest::death_leavesRowsAndRevertRevives()
{
    TreeBuilder builder = randomTree(100, 5);
    InternodeId branch = 1;
    while (builder.index.subtreeSize(branch) > 20)
        ++branch;
    const std::uint32_t carried = builder.index.subtreeSize(branch);
    QVERIFY(carried > 1);
    builder.apply(death(builder.tree, builder.index, branch));
    QCOMPARE(builder.tree.size(), 100U);
    QVERIFY(!builder.tree.isAlive(branch));
    QCOMPARE(builder.tree.columns().death[branch], builder.tree.step());
    QCOMPARE(builder.index.livingCount(), 100U - carried);
    builder.revert();
    QVERIFY(builder.tree.isAlive(branch));
    QCOMPARE(builder.index.livingCount(), 100U);
}

void TreeTest::absentRows_liveAgainWhenTheirBirthIsRedone()
{
    TreeBuilder builder;
    const InternodeId tip = builder.growAxis(0, kTerminalSlot, continuing(), 5);
    TreeDelta growth = builder.revert();
    QCOMPARE(builder.tree.size(), tip + 1);
    QVERIFY(!builder.tree.isAlive(tip));
    QVERIFY((builder.tree.buds(0) & kTerminalBud) != 0);
    // Something else grows in the meantime, under ids of its own, and goes again.
    builder.grow({.parent = 0});
    QCOMPARE(builder.tree.size(), tip + 2);
    builder.revert();
    builder.apply(std::move(growth));
    QVERIFY(builder.tree.isAlive(tip));
    QVERIFY(!builder.tree.isAlive(tip + 1));
    QVERIFY((builder.tree.buds(0) & kTerminalBud) == 0);
}

void TreeTest::rememberedParameters_areKnownOnce()
{
    Tree tree;
    TreeParameters parameters;
    QCOMPARE(tree.rememberParameters(parameters), 0U);
    parameters.growth.shedding = 0.3;
    QCOMPARE(tree.rememberParameters(parameters), 1U);
    QCOMPARE(tree.rememberParameters(parameters), 1U);
    QCOMPARE(tree.currentParameterSet(), 0U); // no delta has put them in force
}

void TreeTest::forgottenParameters_areGone()
{
    Tree tree;
    TreeParameters parameters;
    parameters.growth.shedding = 0.3;
    tree.rememberParameters(parameters);
    tree.forgetLastParameters();
    QCOMPARE(tree.parameterSets().size(), 1);
    QVERIFY(tree == Tree());
}

void TreeTest::parameterChange_leavesWhatHasGrown()
{
    TreeBuilder builder = randomTree(50, 6);
    TreeParameters parameters = builder.tree.parameters();
    parameters.growth.internodeLength = 0.5;
    const InternodeColumns before = builder.tree.columns();
    builder.apply(parameterChange(builder.tree, parameters));
    QVERIFY(builder.tree.columns().length == before.length);
    QVERIFY(builder.tree.parameters() == parameters);
    QVERIFY(builder.tree.parametersOf(49) != parameters);
    const InternodeId grown = builder.grow({.parent = 49, .length = 0.5F});
    QVERIFY(builder.tree.parametersOf(grown) == parameters);
    builder.revert();
    builder.revert();
    QVERIFY(builder.tree.parameters() == builder.tree.parameterSets()[0]);
}

void TreeTest::fromColumns_acceptsWhatATreeHolds()
{
    TreeBuilder builder = randomTree(200, 7);
    builder.apply(death(builder.tree, builder.index, 60));
    builder.apply(randomGrowth(builder.tree, 30, 7));
    builder.revert();
    const Result<Tree> read = reread(builder.tree, builder.tree.columns());
    QVERIFY2(static_cast<bool>(read), read ? "" : qPrintable(read.error().message));
    QVERIFY(*read == builder.tree);
}

void TreeTest::fromColumns_refusesFaults_data()
{
    QTest::addColumn<QString>("fault");
    for (const char* fault : {"short column",
                              "no rows",
                              "parent after child",
                              "parent of itself",
                              "second base",
                              "seedling dead",
                              "rotation not unit",
                              "rotation not a number",
                              "length zero",
                              "length negative",
                              "length not a number",
                              "length infinite",
                              "vigour above one",
                              "vigour not a number",
                              "slot",
                              "bud",
                              "present",
                              "parameters",
                              "born in the future",
                              "died before birth",
                              "two continuations",
                              "alive on the dead"})
        QTest::newRow(fault) << QString::fromLatin1(fault);
}

void TreeTest::fromColumns_refusesFaults()
{
    QFETCH(QString, fault);
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 4);
    builder.growAxis(2, 0, branching(0.8), 3);
    InternodeColumns c = builder.tree.columns();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    if (fault == u"short column")
        c.vigour.removeLast();
    else if (fault == u"no rows")
        c = {};
    else if (fault == u"parent after child")
        c.parent[3] = 6;
    else if (fault == u"parent of itself")
        c.parent[3] = 3;
    else if (fault == u"second base")
        c.parent[3] = kNoInternode;
    else if (fault == u"seedling dead")
        c.death[0] = 1;
    else if (fault == u"rotation not unit")
        c.rotation[3].coeffs() *= 1.1F;
    else if (fault == u"rotation not a number")
        c.rotation[3].x() = nan;
    else if (fault == u"length zero")
        c.length[3] = 0.0F;
    else if (fault == u"length negative")
        c.length[3] = -0.1F;
    else if (fault == u"length not a number")
        c.length[3] = nan;
    else if (fault == u"length infinite")
        c.length[3] = std::numeric_limits<float>::infinity();
    else if (fault == u"vigour above one")
        c.vigour[3] = 1.5F;
    else if (fault == u"vigour not a number")
        c.vigour[3] = nan;
    else if (fault == u"slot")
        c.slot[3] = kMaxLaterals;
    else if (fault == u"bud")
        c.buds[3] = budBit(kMaxLaterals);
    else if (fault == u"present")
        c.present[3] = 2;
    else if (fault == u"parameters")
        c.parameterSet[3] = 1;
    else if (fault == u"born in the future")
        c.birth[3] = builder.tree.step() + 1;
    else if (fault == u"died before birth")
        c.death[6] = c.birth[6] - 1;
    else if (fault == u"two continuations")
        c.slot[5] = kTerminalSlot;
    else if (fault == u"alive on the dead")
        c.death[2] = builder.tree.step();
    const Result<Tree> read = reread(builder.tree, c);
    QVERIFY(!read);
    QVERIFY(!read.error().message.isEmpty());
}

void TreeTest::emptyDelta_isEmpty()
{
    const TreeBuilder builder = randomTree(20, 8);
    QVERIFY(TreeDelta::startingAt(builder.tree).isEmpty());
    QVERIFY(!builder.journal.back().isEmpty());
}

const TestClass<TreeTest> treeTest;

} // namespace espalier::test

#include "TreeTest.moc"

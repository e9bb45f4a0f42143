// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/TreeVariation.h"

#include "tests/model/sketch/BranchTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class TreeVariationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void topology_stays();
    void noAmount_changesNothing();
    void deviations_areAsDocumented();
    void seeds_giveDifferentTrees();
    void otherBranches_haveNoInfluence();
    void farNode_isAnError();
};

namespace {

/// The root of the mean of squares.
struct Spread {
    double sum = 0.0;
    int count = 0;
    void add(double value)
    {
        sum += value * value;
        ++count;
    }
    double deviation() const { return std::sqrt(sum / count); }
};

} // namespace

void TreeVariationTest::topology_stays()
{
    for (TreeBuilder& builder : branchTrees()) {
        const Tree before = builder.tree;
        Result<TreeDelta> delta = varied(builder.tree, builder.index, 4, 0.5);
        QVERIFY(delta);
        QCOMPARE(delta->stepAfter, delta->stepBefore);
        QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
        TreeContent expected = before.content();
        expected.internodes.rotation = builder.tree.columns().rotation;
        expected.internodes.length = builder.tree.columns().length;
        QVERIFY(expected == builder.tree.content());
        for (InternodeId id = 0; id < before.size(); ++id)
            QCOMPARE(before.length(id) != builder.tree.length(id), before.isAlive(id));
    }
}

void TreeVariationTest::noAmount_changesNothing()
{
    const TreeBuilder builder = randomTree(100);
    const Result<TreeDelta> delta = varied(builder.tree, builder.index, 4, 0.0);
    QVERIFY(delta);
    QVERIFY(delta->isEmpty());
}

void TreeVariationTest::deviations_areAsDocumented()
{
    const TreeBuilder original = randomTree(6000, 9);
    for (const double amount : {1.0, 0.4}) {
        TreeBuilder builder = original;
        Result<TreeDelta> delta = varied(builder.tree, builder.index, 11, amount);
        QVERIFY(delta);
        builder.apply(std::move(*delta));
        Spread node;
        Spread around;
        Spread away;
        Spread length;
        for (InternodeId id = 1; id < builder.tree.size(); ++id) {
            const Rotation before = original.tree.columns().rotation[id];
            const Rotation after = builder.tree.columns().rotation[id];
            length.add(std::log(double{builder.tree.length(id)} / double{original.tree.length(id)}));
            if (builder.tree.continuesAxis(id)) {
                node.add(before.cast<double>().angularDistance(after.cast<double>()));
                QVERIFY(before.angularDistance(after) <= 3.5 * amount * radians(4) + 1e-3);
                continue;
            }
            const Vec3 wayBefore = before * Vec3(Vec3::UnitY());
            const Vec3 wayAfter = after * Vec3(Vec3::UnitY());
            away.add(std::acos(std::clamp(double{wayAfter.y()}, -1.0, 1.0)) -
                     std::acos(std::clamp(double{wayBefore.y()}, -1.0, 1.0)));
            around.add(std::remainder(std::atan2(double{wayAfter.z()}, double{wayAfter.x()}) -
                                          std::atan2(double{wayBefore.z()}, double{wayBefore.x()}),
                                      2.0 * std::numbers::pi));
        }
        QVERIFY(std::abs(node.deviation() / (amount * radians(4)) - 1.0) < 0.06);
        QVERIFY(std::abs(around.deviation() / (amount * radians(25)) - 1.0) < 0.1);
        QVERIFY(std::abs(away.deviation() / (amount * radians(10)) - 1.0) < 0.1);
        QVERIFY(std::abs(length.deviation() / (amount * std::hypot(0.2, 0.1)) - 1.0) < 0.15);
    }
}

void TreeVariationTest::seeds_giveDifferentTrees()
{
    const TreeBuilder builder = treeOfDrawing(2, 20);
    const Result<TreeDelta> one = varied(builder.tree, builder.index, 1, 0.3);
    const Result<TreeDelta> again = varied(builder.tree, builder.index, 1, 0.3);
    const Result<TreeDelta> other = varied(builder.tree, builder.index, 2, 0.3);
    QVERIFY(one && again && other);
    QVERIFY(*one == *again);
    QVERIFY(!(*one == *other));
    QCOMPARE(one->internodes.length.size(), std::size_t{builder.tree.size()});
}

void TreeVariationTest::otherBranches_haveNoInfluence()
{
    TreeBuilder builder = randomTree(300, 5);
    TreeBuilder pruned = builder;
    const std::vector<InternodeId> branches = branchesOf(builder);
    pruned.apply(death(pruned.tree, pruned.index, branches[branches.size() / 3]));
    for (TreeBuilder* each : {&builder, &pruned}) {
        Result<TreeDelta> delta = varied(each->tree, each->index, 8, 1.0);
        QVERIFY(delta);
        each->apply(std::move(*delta));
    }
    for (InternodeId id = 0; id < builder.tree.size(); ++id) {
        if (pruned.tree.isAlive(id)) {
            QCOMPARE(pruned.tree.length(id), builder.tree.length(id));
            QCOMPARE(pruned.index.nodePosition(id), builder.index.nodePosition(id));
        }
    }
}

void TreeVariationTest::farNode_isAnError()
{
    TreeBuilder builder;
    for (int i = 0; i < 9; ++i)
        builder.growAxis(builder.tree.size() - 1, kTerminalSlot, Rotation::Identity(), 1,
                         Rotation::Identity(), 999.0F);
    int errors = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Result<TreeDelta> delta = varied(builder.tree, builder.index, seed, 1.0);
        if (delta)
            continue;
        ++errors;
        QCOMPARE(messageOf(delta),
                 QStringLiteral("an internode would be longer than 1000 m or lie more than 10000 m away"));
    }
    QVERIFY(errors > 5);
}

static const TestClass<TreeVariationTest> treeVariationTest;

} // namespace espalier::test

#include "TreeVariationTest.moc"

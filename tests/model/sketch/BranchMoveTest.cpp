// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchMove.h"

#include "model/base/Random.h"
#include "model/sketch/DrawnBranch.h"
#include "tests/model/sketch/BranchTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class BranchMoveTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void branch_standsWhereItIsPutWithAllThatItCarries();
    void samePlace_isNoChange();
    void wrongMoves_areRefused();
};

namespace {

struct MovedLoad {
    std::size_t internodes = 0;
    std::size_t leaves = 0;
    double length = 0.0; ///< m, of all
};

MovedLoad loadOf(const TreeBuilder& builder, InternodeId branch)
{
    MovedLoad carried;
    const LeafColumns& leaves = builder.tree.placedLeaves();
    for (const InternodeId id : internodesOf(builder, branch)) {
        ++carried.internodes;
        carried.length += double{builder.tree.length(id)};
        for (LeafId leaf = 0; leaf < leaves.size(); ++leaf)
            carried.leaves += leaves.internode[leaf] == id && leaves.death[leaf] == kNever ? 1 : 0;
    }
    return carried;
}

bool isOn(const Tree& tree, InternodeId branch, InternodeId id)
{
    while (id != kNoInternode && id > branch)
        id = tree.parent(id);
    return id == branch;
}

} // namespace

void BranchMoveTest::branch_standsWhereItIsPutWithAllThatItCarries()
{
    Random random(7, 0, 0, Purpose::Direction);
    int moves = 0;
    for (TreeBuilder& builder : branchTrees()) {
        for (int i = 0; i < 12; ++i) {
            const std::vector<InternodeId> branches = branchesOf(builder);
            const InternodeId branch = branches[random.bits() % branches.size()];
            InternodeId onto = static_cast<InternodeId>(random.bits() % builder.tree.size());
            if (!builder.tree.isAlive(onto) || isOn(builder.tree, branch, onto))
                onto = 0;
            const BranchMove move{.branch = branch,
                                  .place = {onto, static_cast<float>(random.uniform())},
                                  .rotation = Rotation(Eigen::AngleAxisf(
                                      static_cast<float>(random.uniform(0.0, 3.0)), random.direction())),
                                  .scale = random.uniform(0.5, 2.0)};
            const Vec3 base = positionOf(builder.tree, builder.index, move.place);
            const Vec3 heading = builder.index.rotation(onto) * Vec3(move.rotation * Vec3(Vec3::UnitY()));
            const MovedLoad before = loadOf(builder, branch);
            Result<TreeDelta> delta = moved(builder.tree, builder.index, move);
            QVERIFY(delta);
            const InternodeId there = movedBranch(*delta);
            QCOMPARE(deltaFault(builder, std::move(*delta)), QString());
            QVERIFY(!builder.tree.isAlive(branch));
            const MovedLoad after = loadOf(builder, there);
            QCOMPARE(after.internodes, before.internodes);
            QCOMPARE(after.leaves, before.leaves);
            QVERIFY(std::abs(after.length - move.scale * before.length) < 1e-4 * (1.0 + after.length));
            QVERIFY((builder.index.basePosition(builder.tree, there) - base).norm() < 1e-5F);
            QVERIFY((builder.index.heading(there) - heading).norm() < 1e-5F);
            ++moves;
        }
    }
    QCOMPARE(moves, 72);
}

void BranchMoveTest::samePlace_isNoChange()
{
    TreeBuilder builder = treeOfDrawing(2, 30);
    const InternodeId branch = branchesOf(builder).front();
    const InternodeColumns& c = builder.tree.columns();
    const Result<TreeDelta> delta = moved(
        builder.tree, builder.index,
        {.branch = branch, .place = {c.parent[branch], c.along[branch]}, .rotation = c.rotation[branch]});
    QVERIFY(delta && delta->isEmpty());
}

void BranchMoveTest::wrongMoves_areRefused()
{
    TreeBuilder builder = treeOfDrawing(2, 30);
    const InternodeId branch = branchesOf(builder).front();
    const auto why = [&](const BranchMove& move) {
        const Result<TreeDelta> delta = moved(builder.tree, builder.index, move);
        return delta ? QString() : delta.error().message;
    };
    QCOMPARE(why({.branch = 0, .place = {branch, 1.0F}}), QStringLiteral("a trunk cannot be moved"));
    const InternodeId own = internodesOf(builder, branch).back();
    QCOMPARE(why({.branch = branch, .place = {own, 1.0F}}),
             QStringLiteral("a branch cannot stand on itself"));
    QVERIFY(!why({.branch = branch, .place = {0, 1.0F}, .scale = 0.0}).isEmpty());
    QVERIFY(!why({.branch = branch, .place = {0, 1.0F}, .scale = std::nan("")}).isEmpty());
    QVERIFY(!why({.branch = builder.tree.size(), .place = {0, 1.0F}}).isEmpty());
    builder.apply(death(builder.tree, builder.index, branch));
    QVERIFY(!why({.branch = branch, .place = {0, 1.0F}}).isEmpty());
}

static const TestClass<BranchMoveTest> branchMoveTest;

} // namespace espalier::test

#include "BranchMoveTest.moc"

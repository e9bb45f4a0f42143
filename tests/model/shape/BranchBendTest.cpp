// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/BranchBend.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <algorithm>
#include <cstring>

namespace espalier::test {

class BranchBendTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void path_goesAlongParents();
    void path_toAnotherBranch_isEmpty();
    void changes_areNoneAtRest();
    void changes_makeTheTreeStandAsBent();
    void changes_touchThePathAlone();
    void changes_ofAClosedLoop_leaveTheRowsAsTheyWere();
    void changes_countFromTheTreeAtConstruction();
    void branchThatBeginsAtALateral_bends();
    void foreignHandles_holdNothing();
    void collapsedBranch_keepsAHundredthOfItsLength();
};

namespace {

/// A trunk of 12 internodes, a branch of 15 on the fourth with twigs on each second of its nodes.
struct Sample {
    TreeBuilder builder{7};
    InternodeId trunkTip;
    InternodeId branch;
    InternodeId tip;

    Sample()
    {
        trunkTip = builder.growAxis(0, kTerminalSlot, continuing(0.05), 12, continuing(0.04, 0.3));
        tip = builder.growAxis(4, 0, branching(1.0), 15, continuing(0.06, 1.0));
        branch = tip - 14;
        for (InternodeId id = branch + 1; id < tip; id += 2)
            builder.growAxis(id, 0, branching(0.9), 3);
    }
};

bool sameBits(const FrameChange& a, const FrameChange& b)
{
    return a.id == b.id && a.before == b.before && a.after == b.after && a.lengthBefore == b.lengthBefore &&
           a.lengthAfter == b.lengthAfter;
}

/// The columns' world positions and rotations after @p changes.
std::vector<Placement> placed(const Tree& tree, std::span<const FrameChange> changes)
{
    std::vector<Rotation> rotations(tree.columns().rotation.begin(), tree.columns().rotation.end());
    std::vector<float> lengths(tree.columns().length.begin(), tree.columns().length.end());
    for (const FrameChange& change : changes) {
        rotations[change.id] = change.after;
        lengths[change.id] = change.lengthAfter;
    }
    std::vector<Placement> placements;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        const InternodeId parent = tree.parent(id);
        const bool isBase = parent == kNoInternode;
        placements.push_back(placeOn(isBase ? Vec3(Vec3::Zero()) : placements[parent].node,
                                     isBase ? Rotation(Rotation::Identity()) : placements[parent].rotation,
                                     rotations[id], lengths[id]));
    }
    return placements;
}

BranchBend heldAt(const Sample& sample, InternodeId base, InternodeId end)
{
    const BranchBend::Handle handle{end, 1.0};
    return {sample.builder.tree, sample.builder.index, base, end, std::span(&handle, 1)};
}

void pull(BranchBend& bend, const Vec3& target, int calls = 10)
{
    for (int i = 0; i < calls; ++i)
        bend.solve(std::span(&target, 1));
}

} // namespace

void BranchBendTest::path_goesAlongParents()
{
    const Sample sample;
    const std::vector<InternodeId> path = pathBetween(sample.builder.tree, 2, sample.tip);
    QCOMPARE(path.front(), 2U);
    QCOMPARE(path.back(), sample.tip);
    QCOMPARE(path.size(), std::size_t{3 + 15});
    for (std::size_t i = 1; i < path.size(); ++i)
        QCOMPARE(sample.builder.tree.parent(path[i]), path[i - 1]);
    QCOMPARE(pathBetween(sample.builder.tree, 5, 5), std::vector<InternodeId>{5});
}

void BranchBendTest::path_toAnotherBranch_isEmpty()
{
    const Sample sample;
    QVERIFY(pathBetween(sample.builder.tree, 6, sample.tip).empty());
    QVERIFY(pathBetween(sample.builder.tree, sample.tip, 2).empty());
    BranchBend bend = heldAt(sample, 6, sample.tip);
    pull(bend, Vec3(1, 1, 1));
    QVERIFY(bend.changes().empty());
}

void BranchBendTest::changes_areNoneAtRest()
{
    const Sample sample;
    BranchBend bend = heldAt(sample, 4, sample.tip);
    QVERIFY(bend.changes().empty());
    pull(bend, bend.restPoint({sample.tip, 1.0}));
    QVERIFY(bend.changes().empty());
    pull(bend, Vec3(0, 3, 0));
    QVERIFY(!bend.changes().empty());
    bend.reset();
    QVERIFY(bend.changes().empty());
}

void BranchBendTest::changes_makeTheTreeStandAsBent()
{
    const Sample sample;
    BranchBend bend = heldAt(sample, 3, sample.tip);
    const Vec3 target = bend.restPoint({sample.tip, 1.0}) + Vec3(-0.3F, 0.4F, 0.5F);
    pull(bend, target);
    const auto placements = placed(sample.builder.tree, bend.changes());
    for (std::size_t i = 0; i < bend.path().size(); ++i) {
        const Placement& placement = placements[bend.path()[i]];
        QVERIFY((placement.node.cast<double>() - bend.pose().nodes[i + 1]).norm() < 1e-5);
        QVERIFY(placement.rotation.cast<double>().angularDistance(bend.pose().rotations[i]) < 1e-5);
    }
    QVERIFY((placements[sample.tip].node - target).norm() < 1e-4F);
}

void BranchBendTest::changes_touchThePathAlone()
{
    const Sample sample;
    BranchBend bend = heldAt(sample, 3, sample.tip);
    pull(bend, Vec3(0.5F, 1.0F, 0.5F));
    const auto changes = bend.changes();
    QCOMPARE(changes.size(), bend.path().size() - 1);
    for (const FrameChange& change : changes) {
        QVERIFY(change.id != 3U);
        QVERIFY(std::ranges::count(bend.path(), change.id) == 1);
        QVERIFY(change.before == sample.builder.tree.columns().rotation[change.id]);
        QCOMPARE(change.lengthBefore, sample.builder.tree.length(change.id));
        QVERIFY(change.lengthAfter > 0.0F);
        QVERIFY(std::abs(change.after.norm() - 1.0F) < 1e-5F);
    }
    const auto placements = placed(sample.builder.tree, changes);
    const TreeIndex& index = sample.builder.index;
    for (const InternodeId id : {0U, 1U, 2U, 3U}) {
        QVERIFY(placements[id].node == index.nodePosition(id));
        QVERIFY(placements[id].rotation == index.rotation(id));
    }
    // The trunk goes on above node 4, which is on the path: its first internode hangs on it as before.
    const Rotation before = index.rotation(4).conjugate() * index.rotation(5);
    const Rotation after = placements[4].rotation.conjugate() * placements[5].rotation;
    QVERIFY(before.angularDistance(after) < 1e-3F);
    QVERIFY((placements[5].node - index.nodePosition(5)).norm() > 1e-3F);
}

void BranchBendTest::changes_ofAClosedLoop_leaveTheRowsAsTheyWere()
{
    const Sample sample;
    BranchBend bend = heldAt(sample, 4, sample.tip);
    const Vec3 rest = bend.restPoint({sample.tip, 1.0});
    for (int i = 0; i <= 60; ++i) {
        const double s = 2.0 * std::numbers::pi * i / 60;
        pull(bend,
             rest + Vec3(static_cast<float>(0.5 * std::sin(s)), 0.0F,
                         static_cast<float>(0.4 * (1.0 - std::cos(s)))),
             1);
    }
    pull(bend, rest, 2);
    for (const FrameChange& change : bend.changes()) {
        QVERIFY(change.after.angularDistance(change.before) < 1e-5F);
        QVERIFY(std::abs(change.lengthAfter - change.lengthBefore) < 1e-6F);
    }
}

void BranchBendTest::changes_countFromTheTreeAtConstruction()
{
    Sample sample;
    BranchBend bend = heldAt(sample, 4, sample.tip);
    const InternodeId size = sample.builder.tree.size();
    BranchBend other = heldAt(sample, 4, sample.tip);
    sample.builder.growAxis(sample.tip, kTerminalSlot, continuing(), 5);
    QVERIFY(sample.builder.tree.size() > size);
    pull(bend, Vec3(1, 1, 0));
    pull(other, Vec3(1, 1, 0));
    QVERIFY(std::ranges::equal(bend.changes(), other.changes(), sameBits));
}

void BranchBendTest::branchThatBeginsAtALateral_bends()
{
    const Sample sample;
    BranchBend bend = heldAt(sample, sample.branch, sample.tip);
    const Vec3 target = bend.restPoint({sample.tip, 1.0}) + Vec3(0.0F, 0.3F, 0.0F);
    pull(bend, target);
    QCOMPARE(bend.changes().size(), std::size_t{14});
    QVERIFY((placed(sample.builder.tree, bend.changes())[sample.tip].node - target).norm() < 1e-4F);
}

void BranchBendTest::foreignHandles_holdNothing()
{
    const Sample sample;
    const std::array<BranchBend::Handle, 3> handles{
        {{sample.trunkTip, 1.0}, {sample.tip, 1.0}, {sample.branch, 0.5}}};
    BranchBend bend(sample.builder.tree, sample.builder.index, sample.branch, sample.tip, handles);
    BranchBend single = heldAt(sample, sample.branch, sample.tip);
    const Vec3 target = bend.restPoint(handles[1]) + Vec3(0.0F, 0.2F, 0.1F);
    bend.solve(std::vector<Vec3>{Vec3(9, 9, 9), target, Vec3(-9, 9, 9)});
    pull(single, target, 1);
    QVERIFY(!bend.changes().empty());
    QVERIFY(std::ranges::equal(bend.changes(), single.changes(), sameBits));
}

void BranchBendTest::collapsedBranch_keepsAHundredthOfItsLength()
{
    const Sample sample;
    BranchBend bend = heldAt(sample, sample.tip - 1, sample.tip);
    pull(bend, sample.builder.index.nodePosition(sample.tip - 1));
    const auto changes = bend.changes();
    QCOMPARE(changes.size(), std::size_t{1});
    QVERIFY(changes[0].lengthAfter >= 0.0099F * changes[0].lengthBefore);
    QVERIFY(changes[0].after.coeffs().allFinite());
}

const TestClass<BranchBendTest> branchBendTest;

} // namespace espalier::test

#include "BranchBendTest.moc"

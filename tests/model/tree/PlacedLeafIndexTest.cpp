// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/PlacedLeafIndex.h"

#include "tests/support/PlacedLeaves.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <set>

namespace espalier::test {

class PlacedLeafIndexTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void lists_areThoseOfTheRows();
    void lists_followDeltasForwardsAndBackwards();
    void shown_areLivingLeavesOnLivingWood();
    void bounds_holdTheBlades();
};

namespace {

std::vector<LeafId> listOf(const PlacedLeafIndex& index, InternodeId id)
{
    std::vector<LeafId> list;
    for (LeafId leaf = index.first(id); leaf != kNoLeaf; leaf = index.next(leaf))
        list.push_back(leaf);
    return list;
}

/// The rows of the leaves that a tree's internode has had.
std::vector<LeafId> rowsOf(const Tree& tree, InternodeId id)
{
    std::vector<LeafId> rows;
    for (LeafId leaf = 0; leaf < tree.placedLeaves().size(); ++leaf) {
        if (tree.placedLeaves().internode[leaf] == id)
            rows.push_back(leaf);
    }
    return rows;
}

/// Everything that is known of the leaves of each internode.
std::vector<std::vector<LeafRow>> leavesByInternode(const Tree& tree, InternodeId count)
{
    std::vector<std::vector<LeafRow>> all(count);
    for (LeafId leaf = 0; leaf < tree.placedLeaves().size(); ++leaf)
        all[tree.placedLeaves().internode[leaf]].push_back(leafRow(tree, leaf));
    return all;
}

bool areEqual(const std::vector<LeafRow>& one, const std::vector<LeafRow>& other)
{
    return std::ranges::equal(one, other, [](const LeafRow& a, const LeafRow& b) {
        return a.along == b.along && a.rotation == b.rotation && a.length == b.length && a.kind == b.kind &&
               a.birth == b.birth && a.death == b.death;
    });
}

} // namespace

void PlacedLeafIndexTest::lists_areThoseOfTheRows()
{
    TreeBuilder builder = randomTree(40, 2);
    QVERIFY(PlacedLeafIndex(builder.tree).isEmpty());
    Random random(4, 0, 0, Purpose::Direction);
    for (int i = 0; i < 30; ++i)
        builder.apply(randomLeafEdit(builder.tree, random));
    const PlacedLeafIndex index(builder.tree);
    QVERIFY(!index.isEmpty());
    for (InternodeId id = 0; id < builder.tree.size(); ++id)
        QCOMPARE(listOf(index, id), rowsOf(builder.tree, id));
}

void PlacedLeafIndexTest::lists_followDeltasForwardsAndBackwards()
{
    TreeBuilder builder = randomTree(30, 3);
    PlacedLeafIndex index(builder.tree);
    Random random(5, 0, 0, Purpose::Direction);
    std::vector<TreeDelta> undone;
    for (int step = 0; step < 400; ++step) {
        const Tree before = builder.tree;
        const std::uint64_t choice = random.bits() % 8;
        if (choice < 2 && builder.journal.size() > 4) {
            undone.push_back(builder.revert());
            index.update(builder.tree, undone.back());
        } else if (choice < 4 && !undone.empty()) {
            index.update(builder.tree, builder.apply(std::move(undone.back())));
            undone.pop_back();
        } else {
            undone.clear();
            index.update(builder.tree,
                         builder.apply(choice == 4 ? randomGrowth(builder.tree, 3, random.bits())
                                                   : randomLeafEdit(builder.tree, random)));
        }
        const InternodeId count = std::max(before.size(), builder.tree.size());
        const auto old = leavesByInternode(before, count);
        const auto now = leavesByInternode(builder.tree, count);
        std::vector<InternodeId> changed;
        for (InternodeId id = 0; id < count; ++id) {
            QCOMPARE(listOf(index, id), rowsOf(builder.tree, id));
            if (!areEqual(old[id], now[id]))
                changed.push_back(id);
        }
        QVERIFY(std::ranges::equal(index.recentlyChanged(), changed));
    }
}

void PlacedLeafIndexTest::shown_areLivingLeavesOnLivingWood()
{
    TreeBuilder builder;
    const InternodeId tip = builder.growAxis(0, kTerminalSlot, continuing(), 5);
    const std::vector<InternodeId> carriers{2, tip, tip};
    builder.apply(leafPlacement(builder.tree, carriers));
    QCOMPARE(placedLeafCount(builder.tree), std::uint64_t{3});
    builder.apply(leafRemoval(builder.tree, 1));
    QVERIFY(isPlacedLeafShown(builder.tree, 0) && !isPlacedLeafShown(builder.tree, 1) &&
            isPlacedLeafShown(builder.tree, 2));
    builder.apply(death(builder.tree, builder.index, 4));
    QVERIFY(isPlacedLeafShown(builder.tree, 0) && !isPlacedLeafShown(builder.tree, 2));
    TreeParameters parameters = builder.tree.parameters();
    parameters.leaves.visible = false;
    builder.apply(parameterChange(builder.tree, parameters));
    QCOMPARE(placedLeafCount(builder.tree), std::uint64_t{0});
    for (int i = 0; i < 3; ++i)
        builder.revert();
    QCOMPARE(placedLeafCount(builder.tree), std::uint64_t{3});
}

void PlacedLeafIndexTest::bounds_holdTheBlades()
{
    TreeBuilder builder; // a seedling that stands upright
    TreeDelta delta = deltaStartingAt(builder.tree);
    // The midrib turns from up to +X.
    addLeaf(
        delta,
        leafAt(0, 0.5F, Rotation(Eigen::AngleAxisf(-0.5F * std::numbers::pi_v<float>, Vec3::UnitZ())), 2.0F));
    builder.apply(std::move(delta));
    Box3 bounds{Vec3(Vec3::Zero())};
    extendByPlacedLeaves(bounds, builder.tree, builder.index);
    QVERIFY(std::abs(bounds.max().x() - 2.0F) < 1e-5F);
    QVERIFY(bounds.min().x() > -1e-5F);
    QVERIFY((placedLeafBase(builder.tree, builder.index, 0) - Vec3(0.0F, 0.5F * builder.tree.length(0), 0.0F))
                .norm() < 1e-6F);
    QVERIFY(
        (placedLeafFrame(builder.tree, builder.index, 0) * Vec3(Vec3::UnitY()) - Vec3(Vec3::UnitX())).norm() <
        1e-6F);
    builder.apply(leafRemoval(builder.tree, 0));
    Box3 without{Vec3(Vec3::Zero())};
    extendByPlacedLeaves(without, builder.tree, builder.index);
    QCOMPARE(without.max().x(), 0.0F);
}

const TestClass<PlacedLeafIndexTest> placedLeafIndexTest;

} // namespace espalier::test

#include "PlacedLeafIndexTest.moc"

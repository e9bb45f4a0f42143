// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/TreeIndex.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>
#include <set>

namespace espalier::test {

class TreeIndexTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void children_areTheLivingOnesByAscendingId();
    void axes_runThroughContinuations();
    void nodes_standWhereTheirFramesLead();
    void sums_countWhatASubtreeCarries();
    void afterAnyEdits_theIndexIsAsIfFreshlyMade();
    void recentlyChanged_namesExactlyWhatChanged();
    void longAxis_staysStraightAndUnitLength();
    void greatestLength_isThatOfTheLongestInternode();
    void wideNode_isIndexedInTimeInProportionToItsChildren();
    void internodeBornAndShedInOneStep_isForgottenWhenThatIsReverted();
    void internodeBornAndStretchedInOneStep_isForgottenWhenThatIsReverted();
};

namespace {

std::vector<InternodeId> childrenOf(const TreeIndex& index, InternodeId id)
{
    std::vector<InternodeId> result;
    for (InternodeId child = index.firstChild(id); child != kNoInternode; child = index.nextSibling(child))
        result.push_back(child);
    return result;
}

} // namespace

void TreeIndexTest::children_areTheLivingOnesByAscendingId()
{
    TreeBuilder builder = randomTree(600, 1);
    builder.apply(death(builder.tree, builder.index, 100));
    builder.apply(death(builder.tree, builder.index, 20));
    const Tree& tree = builder.tree;
    std::vector<std::vector<InternodeId>> expected(tree.size());
    for (InternodeId id = 1; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            expected[tree.parent(id)].push_back(id);
    }
    for (InternodeId id = 0; id < tree.size(); ++id) {
        QVERIFY(childrenOf(builder.index, id) == expected[id]);
        const auto main =
            std::ranges::find_if(expected[id], [&](InternodeId child) { return tree.continuesAxis(child); });
        QCOMPARE(builder.index.mainChild(id), main == expected[id].end() ? kNoInternode : *main);
    }
}

void TreeIndexTest::axes_runThroughContinuations()
{
    const TreeBuilder builder = randomTree(500, 2);
    for (InternodeId id = 1; id < builder.tree.size(); ++id) {
        QCOMPARE(builder.index.axis(id),
                 builder.tree.continuesAxis(id) ? builder.index.axis(builder.tree.parent(id)) : id);
    }
    QCOMPARE(builder.index.axis(0), 0U);
}

void TreeIndexTest::nodes_standWhereTheirFramesLead()
{
    const TreeBuilder builder = randomTree(500, 3);
    const Tree& tree = builder.tree;
    std::vector<Eigen::Isometry3d> frames;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        Eigen::Isometry3d frame = id == 0 ? Eigen::Isometry3d::Identity() : frames[tree.parent(id)];
        frame.rotate(Eigen::Quaternionf(tree.columns().rotation[id]).cast<double>().normalized());
        frame.translate(Eigen::Vector3d(0.0, static_cast<double>(tree.length(id)), 0.0));
        frames.push_back(frame);
        QVERIFY((builder.index.nodePosition(id).cast<double>() - frame.translation()).norm() < 1e-4);
        QVERIFY((builder.index.heading(id).cast<double>() - frame.linear().col(1)).norm() < 1e-4);
    }
}

void TreeIndexTest::sums_countWhatASubtreeCarries()
{
    TreeBuilder builder = randomTree(500, 4);
    builder.apply(death(builder.tree, builder.index, 77));
    const Tree& tree = builder.tree;
    std::vector<std::uint32_t> sizes(tree.size(), 0);
    std::vector<std::uint32_t> tips(tree.size(), 0);
    std::uint32_t living = 0;
    for (InternodeId id = tree.size(); id-- > 0;) {
        if (!tree.isAlive(id))
            continue;
        ++living;
        ++sizes[id];
        tips[id] = std::max(tips[id], 1U);
        if (id > 0) {
            sizes[tree.parent(id)] += sizes[id];
            tips[tree.parent(id)] += tips[id];
        }
    }
    for (InternodeId id = 0; id < tree.size(); ++id) {
        QCOMPARE(builder.index.subtreeSize(id), sizes[id]);
        QCOMPARE(builder.index.tipCount(id), tips[id]);
    }
    QCOMPARE(builder.index.livingCount(), living);
}

void TreeIndexTest::afterAnyEdits_theIndexIsAsIfFreshlyMade()
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        TreeBuilder builder(seed);
        Random random(seed, 0, 0, Purpose::ShootLength);
        std::vector<TreeDelta> undone;
        for (int edit = 0; edit < 120; ++edit) {
            const auto kind = random.bits() % 8;
            if (kind < 3) {
                undone.clear();
                builder.apply(randomGrowth(builder.tree, 12, seed + static_cast<std::uint64_t>(edit)));
            } else if (kind == 3) {
                const auto id = static_cast<InternodeId>(random.bits() % builder.tree.size());
                if (id > 0 && builder.tree.isAlive(id)) {
                    undone.clear();
                    builder.apply(death(builder.tree, builder.index, id));
                }
            } else if (kind == 4 && !builder.journal.empty()) {
                undone.push_back(builder.revert());
            } else if (kind == 5 && !undone.empty()) {
                builder.apply(std::move(undone.back()));
                undone.pop_back();
            } else if (kind == 6) {
                undone.clear();
                const auto id = static_cast<InternodeId>(random.bits() % builder.tree.size());
                const auto stretch = static_cast<float>(random.uniform(0.3, 3.0));
                builder.apply(bend(builder.tree, id, Rotation::Identity(), stretch));
            } else if (kind == 7 && builder.index.roots().size() < 4) {
                undone.clear();
                const Vec3 place(static_cast<float>(edit), 0.0F, 0.0F);
                builder.apply(rootBirth(builder.tree, builder.index, place));
            }
            const TreeIndex fresh(builder.tree);
            QCOMPARE(builder.index.greatestLength(), fresh.greatestLength());
            QCOMPARE(builder.index.greatestTipCount(), fresh.greatestTipCount());
            QVERIFY(std::ranges::equal(builder.index.roots(), fresh.roots()));
            QCOMPARE(builder.index.size(), fresh.size());
            QCOMPARE(builder.index.livingCount(), fresh.livingCount());
            for (InternodeId id = 0; id < fresh.size(); ++id) {
                QCOMPARE(builder.index.firstChild(id), fresh.firstChild(id));
                QCOMPARE(builder.index.nextSibling(id), fresh.nextSibling(id));
                QCOMPARE(builder.index.mainChild(id), fresh.mainChild(id));
                QCOMPARE(builder.index.axis(id), fresh.axis(id));
                QCOMPARE(builder.index.subtreeSize(id), fresh.subtreeSize(id));
                QCOMPARE(builder.index.tipCount(id), fresh.tipCount(id));
                QCOMPARE(builder.index.nodePosition(id), fresh.nodePosition(id));
                QVERIFY(builder.index.rotation(id).coeffs() == fresh.rotation(id).coeffs());
            }
        }
    }
}

void TreeIndexTest::recentlyChanged_namesExactlyWhatChanged()
{
    TreeBuilder builder = randomTree(300, 9);
    for (int edit = 0; edit < 20; ++edit) {
        const TreeIndex before = builder.index;
        builder.apply(edit % 4 == 3 ? death(builder.tree, builder.index, 250 - static_cast<InternodeId>(edit))
                                    : randomGrowth(builder.tree, 10, static_cast<std::uint64_t>(edit)));
        std::set<InternodeId> expected;
        for (InternodeId id = 0; id < builder.index.size(); ++id) {
            const bool isNew = id >= before.size();
            if (builder.index.subtreeSize(id) != (isNew ? 0 : before.subtreeSize(id)) ||
                builder.index.tipCount(id) != (isNew ? 0 : before.tipCount(id)))
                expected.insert(id);
        }
        const auto changed = builder.index.recentlyChanged();
        QVERIFY(std::ranges::equal(changed, std::vector<InternodeId>(expected.rbegin(), expected.rend())));
    }
}

void TreeIndexTest::greatestLength_isThatOfTheLongestInternode()
{
    TreeBuilder builder = randomTree(200, 4);
    const auto longest = [&] { return *std::ranges::max_element(builder.tree.columns().length); };
    QCOMPARE(builder.index.greatestLength(), longest());
    builder.apply(bend(builder.tree, 50, Rotation::Identity(), 9.0F));
    QCOMPARE(builder.index.greatestLength(), longest());
    builder.revert();
    QCOMPARE(builder.index.greatestLength(), longest());
    const float before = longest();
    builder.grow({.parent = 50, .slot = 0, .length = 7.0F});
    builder.grow({.parent = 60, .slot = 0, .length = 7.0F});
    builder.revert();
    QCOMPARE(builder.index.greatestLength(), 7.0F);
    builder.revert();
    QCOMPARE(builder.index.greatestLength(), before);
}

void TreeIndexTest::wideNode_isIndexedInTimeInProportionToItsChildren()
{
    constexpr std::uint32_t count = 100'000;
    TreeBuilder builder;
    const InternodeId sibling = builder.grow({.parent = 0});
    QElapsedTimer clock;
    clock.start();
    const std::vector<NewInternode> fan(count, {.parent = 0, .slot = 0});
    builder.apply(births(builder.tree, fan));
    const auto isComplete = [&](const TreeIndex& index) {
        const std::vector<InternodeId> children = childrenOf(index, 0);
        return children.size() == count + 1 && std::ranges::is_sorted(children) &&
               index.mainChild(0) == sibling;
    };
    QVERIFY(isComplete(builder.index));
    QVERIFY(isComplete(TreeIndex(builder.tree)));
    const TreeDelta fanDelta = builder.revert();
    QVERIFY(childrenOf(builder.index, 0) == std::vector<InternodeId>{sibling});
    builder.apply(fanDelta);
    // From the last to the first, and every second one.
    TreeDelta deaths = deltaStartingAt(builder.tree);
    for (InternodeId id = builder.tree.size() - 1; id > sibling; id -= 2)
        deaths.died.push_back(id);
    builder.apply(deaths);
    QCOMPARE(childrenOf(builder.index, 0).size(), std::size_t{count / 2 + 1});
    builder.revert();
    QVERIFY(isComplete(builder.index));
    // To walk the list of children for each of them takes a hundred times as long.
    QVERIFY2(clock.elapsed() < 15'000, qPrintable(QStringLiteral("%1 ms").arg(clock.elapsed())));
}

void TreeIndexTest::internodeBornAndShedInOneStep_isForgottenWhenThatIsReverted()
{
    TreeBuilder builder = randomTree(50, 3);
    const Tree before = builder.tree;
    const std::uint32_t living = builder.index.livingCount();
    TreeDelta delta = randomGrowth(builder.tree, 6);
    delta.died = {delta.born.end() - 1};
    builder.apply(std::move(delta));
    QCOMPARE(builder.index.livingCount(), living + 5);
    builder.apply(builder.revert());
    QCOMPARE(builder.index.livingCount(), living + 5);
    builder.revert();
    QCOMPARE(builder.index.livingCount(), living);
    QVERIFY(builder.tree == before);
}

void TreeIndexTest::internodeBornAndStretchedInOneStep_isForgottenWhenThatIsReverted()
{
    TreeBuilder builder;
    const float longest = builder.index.greatestLength();
    // New rows far beyond the end of the tree that stays.
    const std::vector<NewInternode> fan(100'000, {.parent = 0, .slot = 0, .length = 7.0F});
    TreeDelta delta = births(builder.tree, fan);
    const InternodeId last = delta.born.end() - 1;
    delta.addFrame(last, Rotation::Identity(), continuing(0.5), 7.0F, 2.0F * longest);
    for (InternodeId id = delta.born.first; id < last; ++id)
        delta.internodes.length.push_back({id, 7.0F, longest});
    delta.internodes.buds.push_back({last, delta.rows->internodes.buds.back(), BudStates()});
    builder.apply(delta);
    QCOMPARE(builder.index.greatestLength(), 2.0F * longest);
    builder.apply(builder.revert());
    QCOMPARE(builder.index.greatestLength(), 2.0F * longest);
    builder.revert();
    QCOMPARE(builder.index.greatestLength(), longest);
    QVERIFY(builder.index.recentlyMoved().empty());
}

void TreeIndexTest::longAxis_staysStraightAndUnitLength()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 20000);
    const InternodeId tip = builder.tree.size() - 1;
    QVERIFY(std::abs(builder.index.rotation(tip).norm() - 1.0F) < 1e-5F);
    QVERIFY((builder.index.heading(tip) - up()).norm() < 1e-3F);
    QVERIFY(std::abs(builder.index.nodePosition(tip).y() - 2000.1F) < 2.0F);
}

const TestClass<TreeIndexTest> treeIndexTest;

} // namespace espalier::test

#include "TreeIndexTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/picking/PickIndex.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <map>

using namespace espalier;
using namespace espalier::test;

class PickIndexTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void edits_areFollowedBothWays();
    void rowsThatAreGone_areForgotten();
    void settle_costsWhatChanged();
    void manyChanges_costOneReading();
    void cells_followTheDensityOfTheTree();
    void nodesAtOnePlaceAndFarAway_areFound();
};

namespace {

/// The difference between the index and the living nodes of the tree; empty if there is none.
QString fault(const PickIndex& nodes, const Tree& tree, const TreeIndex& index)
{
    std::map<InternodeId, Vec3> found;
    QString fault;
    nodes.forEachCell([&](const Vec3& centre, float radius, PickIndex::Nodes inside) {
        for (const PickIndex::Node& node : inside) {
            if (!found.emplace(node.id, node.position()).second)
                fault = QStringLiteral("node %1 is there twice").arg(node.id);
            if ((node.position() - centre).norm() > radius * 1.0001F + 1e-5F)
                fault = QStringLiteral("node %1 is outside its cell's ball").arg(node.id);
        }
    });
    std::uint32_t living = 0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        ++living;
        const auto known = found.find(id);
        if (known == found.end())
            fault = QStringLiteral("node %1 is missing").arg(id);
        else if (known->second != index.nodePosition(id))
            fault = QStringLiteral("node %1 is in the wrong place").arg(id);
    }
    if (found.size() != living || nodes.nodeCount() != living)
        fault +=
            QStringLiteral("; %1 and %2 nodes for %3").arg(found.size()).arg(nodes.nodeCount()).arg(living);
    return fault;
}

InternodeId anyLiving(const Tree& tree, Random& random)
{
    for (;;) {
        const auto id = static_cast<InternodeId>(random.bits() % tree.size());
        if (tree.isAlive(id))
            return id;
    }
}

} // namespace

void PickIndexTest::edits_areFollowedBothWays()
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        TreeBuilder builder = randomTree(400, seed);
        Random random(seed, 3, 0, Purpose::Direction);
        PickIndex nodes;
        nodes.settle(builder.tree, builder.index);
        QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
        for (int edit = 0; edit < 80; ++edit) {
            const auto kind = random.bits() % 5;
            const InternodeId id = anyLiving(builder.tree, random);
            if (kind == 0 && builder.journal.size() > 4) {
                const TreeDelta delta = builder.revert();
                nodes.follow(builder.tree, builder.index, delta);
                continue;
            }
            if (kind == 1 && id != 0)
                builder.apply(death(builder.tree, builder.index, id));
            else if (kind == 2)
                builder.apply(bend(builder.tree, id, continuing(0.3), 1.2F));
            else
                builder.apply(randomGrowth(builder.tree, 12, seed + static_cast<std::uint64_t>(edit)));
            nodes.follow(builder.tree, builder.index, builder.journal.back());
            // Several edits can happen between two queries.
            if (random.uniform() < 0.5) {
                nodes.settle(builder.tree, builder.index);
                QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
            }
        }
        nodes.settle(builder.tree, builder.index);
        QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
    }
}

void PickIndexTest::rowsThatAreGone_areForgotten()
{
    TreeBuilder shorter = randomTree(300);
    TreeBuilder longer = shorter;
    const TreeDelta& delta = longer.apply(randomGrowth(longer.tree, 50, 8));
    PickIndex nodes;
    nodes.settle(longer.tree, longer.index);
    // The tree has the same end as before the delta.
    nodes.follow(shorter.tree, shorter.index, delta);
    nodes.settle(shorter.tree, shorter.index);
    QCOMPARE(fault(nodes, shorter.tree, shorter.index), QString());

    // Before the next query, other internodes get the ids of the removed ones.
    nodes = {};
    nodes.settle(longer.tree, longer.index);
    nodes.follow(shorter.tree, shorter.index, delta);
    nodes.follow(shorter.tree, shorter.index, shorter.apply(randomGrowth(shorter.tree, 30, 9)));
    nodes.settle(shorter.tree, shorter.index);
    QCOMPARE(fault(nodes, shorter.tree, shorter.index), QString());
}

void PickIndexTest::settle_costsWhatChanged()
{
    TreeBuilder builder = randomTree(6'000);
    PickIndex nodes;
    nodes.settle(builder.tree, builder.index);
    nodes.settle(builder.tree, builder.index);
    QCOMPARE(nodes.lastCost(), std::size_t{0});
    nodes.follow(builder.tree, builder.index, builder.apply(randomGrowth(builder.tree, 20, 5)));
    nodes.settle(builder.tree, builder.index);
    QVERIFY2(nodes.lastCost() <= 60, qPrintable(QString::number(nodes.lastCost())));
    nodes.follow(builder.tree, builder.index, builder.revert());
    nodes.settle(builder.tree, builder.index);
    QVERIFY2(nodes.lastCost() <= 60, qPrintable(QString::number(nodes.lastCost())));
    QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
}

void PickIndexTest::manyChanges_costOneReading()
{
    TreeBuilder builder = randomTree(500);
    PickIndex nodes;
    nodes.settle(builder.tree, builder.index);
    while (builder.tree.size() < 12'000)
        nodes.follow(builder.tree, builder.index, builder.apply(randomGrowth(builder.tree, 300, 2)));
    // The noted changes until the next query are limited by the size of the tree.
    QVERIFY(nodes.bytes() < 40 * builder.tree.size());
    nodes.settle(builder.tree, builder.index);
    QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
}

void PickIndexTest::cells_followTheDensityOfTheTree()
{
    // From a seedling, with a query, to a dense crown of internodes a tenth as long.
    TreeBuilder builder;
    PickIndex nodes;
    nodes.settle(builder.tree, builder.index);
    TreeParameters fine;
    fine.growth.internodeLength = 0.01;
    nodes.follow(builder.tree, builder.index, builder.apply(parameterChange(builder.tree, fine)));
    while (builder.tree.size() < 20'000) {
        nodes.follow(builder.tree, builder.index, builder.apply(randomGrowth(builder.tree, 500, 4)));
        nodes.settle(builder.tree, builder.index);
    }
    QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
    const std::size_t perCell = nodes.nodeCount() / nodes.cellCount();
    QVERIFY2(perCell <= 320, qPrintable(QString::number(perCell)));
}

void PickIndexTest::nodesAtOnePlaceAndFarAway_areFound()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 3'000, continuing(), 1e-30F);
    const InternodeId far = builder.growAxis(builder.tree.size() - 1, kTerminalSlot, continuing(), 3'000,
                                             continuing(), kGreatestLength);
    PickIndex nodes;
    nodes.settle(builder.tree, builder.index);
    QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
    nodes.follow(builder.tree, builder.index, builder.apply(death(builder.tree, builder.index, far - 2'500)));
    nodes.settle(builder.tree, builder.index);
    QCOMPARE(fault(nodes, builder.tree, builder.index), QString());
}

static const TestClass<PickIndexTest> pickIndexTest;

#include "PickIndexTest.moc"

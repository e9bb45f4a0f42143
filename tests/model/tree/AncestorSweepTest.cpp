// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/AncestorSweep.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <map>

namespace espalier::test {

class AncestorSweepTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sweep_carriesDifferencesToTheBaseChildrenFirst();
    void sweep_endsWhereDifferencesCancel();
    void sweep_forgetsItsDifferences();
    void truncate_removesTheDifferencesOfLaterIds();
    void sweepThatTouchesMuch_keepsLittleMemory();
    void noDifference_visitsNothing();
};

namespace {

using Differences = std::map<InternodeId, std::int64_t>;

/// What @p sweep visits; checks the order.
Differences visited(AncestorSweep<std::int64_t>& sweep, const Tree& tree)
{
    Differences result;
    sweep.run(tree.columns().parent, [&](InternodeId id, std::int64_t difference) {
        QVERIFY(result.empty() || id < result.begin()->first);
        result[id] = difference;
    });
    return result;
}

/// The sum of @p added at and above each internode, where it is not 0.
Differences expected(const Differences& added, const Tree& tree)
{
    Differences sums;
    for (const auto& [at, difference] : added) {
        for (InternodeId id = at; id != kNoInternode; id = tree.parent(id))
            sums[id] += difference;
    }
    std::erase_if(sums, [](const auto& entry) { return entry.second == 0; });
    return sums;
}

} // namespace

void AncestorSweepTest::sweep_carriesDifferencesToTheBaseChildrenFirst()
{
    const TreeBuilder builder = randomTree(3000, 5);
    const Tree& tree = builder.tree;
    Random random(1, 0, 0, Purpose::ShootLength);
    AncestorSweep<std::int64_t> sweep;
    for (int round = 0; round < 40; ++round) {
        Differences added;
        for (int i = 0; i < round * round; ++i) {
            const auto id = static_cast<InternodeId>(random.bits() % tree.size());
            const auto difference = static_cast<std::int64_t>(random.bits() % 7) - 3;
            sweep.add(id, difference);
            added[id] += difference;
        }
        QCOMPARE(visited(sweep, tree), expected(added, tree));
    }
}

void AncestorSweepTest::sweep_endsWhereDifferencesCancel()
{
    const QList<InternodeId> parents{kNoInternode, 0, 1, 1};
    AncestorSweep<std::int64_t> sweep;
    sweep.add(2, 5);
    sweep.add(3, -5);
    std::vector<InternodeId> ids;
    sweep.run(parents, [&](InternodeId id, std::int64_t) { ids.push_back(id); });
    QCOMPARE(ids, (std::vector<InternodeId>{3, 2}));
}

void AncestorSweepTest::sweep_forgetsItsDifferences()
{
    const QList<InternodeId> parents{kNoInternode, 0, 1, 1};
    AncestorSweep<std::int64_t> sweep;
    sweep.add(3, 1);
    int visits = 0;
    sweep.run(parents, [&](InternodeId, std::int64_t) { ++visits; });
    QCOMPARE(visits, 3);
    sweep.run(parents, [&](InternodeId, std::int64_t) { ++visits; });
    QCOMPARE(visits, 3);
}

void AncestorSweepTest::truncate_removesTheDifferencesOfLaterIds()
{
    const TreeBuilder builder = randomTree(1000, 6);
    Random random(2, 0, 0, Purpose::ShootLength);
    AncestorSweep<std::int64_t> sweep;
    for (const InternodeId size : {0U, 1U, 63U, 64U, 65U, 128U, 500U, 960U, 999U, 1000U, 5000U}) {
        Differences added;
        for (int i = 0; i < 300; ++i) {
            const auto id = static_cast<InternodeId>(random.bits() % builder.tree.size());
            sweep.add(id, 1);
            if (id < size)
                ++added[id];
        }
        sweep.truncate(size);
        // Later ids can be used again.
        sweep.add(builder.tree.size() - 1, 4);
        added[builder.tree.size() - 1] += 4;
        QCOMPARE(visited(sweep, builder.tree), expected(added, builder.tree));
    }
}

void AncestorSweepTest::sweepThatTouchesMuch_keepsLittleMemory()
{
    constexpr InternodeId size = 200'000;
    const QList<InternodeId> parents(size, kNoInternode);
    AncestorSweep<std::int64_t> sweep;
    for (InternodeId id = 0; id < size; ++id)
        sweep.add(id, 1);
    QVERIFY(sweep.bytes() >= size * sizeof(std::int64_t));
    InternodeId visits = 0;
    sweep.run(parents, [&](InternodeId, std::int64_t) { ++visits; });
    QCOMPARE(visits, size);
    QVERIFY2(sweep.bytes() < size / 2, qPrintable(QString::number(sweep.bytes())));
    // A path through the whole tree needs a page or two, one after another.
    QList<InternodeId> chain{kNoInternode};
    while (chain.size() < static_cast<qsizetype>(size))
        chain.append(static_cast<InternodeId>(chain.size() - 1));
    sweep.add(size - 1, 1);
    sweep.run(chain, [&](InternodeId, std::int64_t) { --visits; });
    QCOMPARE(visits, InternodeId{0});
    QVERIFY2(sweep.bytes() < size / 2, qPrintable(QString::number(sweep.bytes())));
}

void AncestorSweepTest::noDifference_visitsNothing()
{
    AncestorSweep<std::int64_t> sweep;
    sweep.run({}, [](InternodeId, std::int64_t) { QFAIL("nothing was added"); });
}

const TestClass<AncestorSweepTest> ancestorSweepTest;

} // namespace espalier::test

#include "AncestorSweepTest.moc"

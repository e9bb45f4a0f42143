// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/AncestorSweep.h"

#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QtTest>

#include <set>

namespace espalier::test {

class AncestorSweepTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sweep_visitsMarkedAndAncestorsOnceChildrenFirst();
    void sweep_forgetsItsMarks();
    void nothingMarked_visitsNothing();
};

void AncestorSweepTest::sweep_visitsMarkedAndAncestorsOnceChildrenFirst()
{
    const TreeBuilder builder = randomTree(3000, 5);
    const Tree& tree = builder.tree;
    Random random(1, 0, 0, Purpose::ShootLength);
    AncestorSweep sweep;
    for (int round = 0; round < 20; ++round) {
        std::set<InternodeId> expected;
        for (int i = 0; i < round * 3; ++i) {
            const auto marked = static_cast<InternodeId>(random.bits() % tree.size());
            sweep.mark(marked);
            for (InternodeId id = marked; id != kNoInternode; id = tree.parent(id))
                expected.insert(id);
        }
        std::vector<InternodeId> visited;
        sweep.run(tree.columns().parent, [&](InternodeId id, InternodeId parent) {
            QCOMPARE(parent, tree.parent(id));
            visited.push_back(id);
        });
        QVERIFY(std::ranges::equal(visited, std::vector<InternodeId>(expected.rbegin(), expected.rend())));
    }
}

void AncestorSweepTest::sweep_forgetsItsMarks()
{
    const QList<InternodeId> parents{kNoInternode, 0, 1, 1};
    AncestorSweep sweep;
    sweep.mark(3);
    int visits = 0;
    sweep.run(parents, [&](InternodeId, InternodeId) { ++visits; });
    QCOMPARE(visits, 3);
    sweep.run(parents, [&](InternodeId, InternodeId) { ++visits; });
    QCOMPARE(visits, 3);
}

void AncestorSweepTest::nothingMarked_visitsNothing()
{
    AncestorSweep sweep;
    sweep.run({}, [](InternodeId, InternodeId) { QFAIL("nothing was marked"); });
}

const TestClass<AncestorSweepTest> ancestorSweepTest;

} // namespace espalier::test

#include "AncestorSweepTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/JoinedForks.h"

#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <set>

namespace espalier::test {

namespace {

StrandSkeleton skeletonAt(TreeBuilder& builder, double alpha)
{
    TreeParameters parameters = builder.tree.parameters();
    parameters.wood.alpha = alpha;
    builder.apply(parameterChange(builder.tree, parameters));
    return strandSkeleton(builder.tree, builder.index, Widths(builder.tree, builder.index));
}

/// The number of particles, which is greater where strands of two branches pass each other's nodes.
std::uint64_t particlesOf(const StrandSkeleton& skeleton)
{
    std::uint64_t particles = 0;
    for (const StrandNode& node : skeleton.nodes)
        particles += node.strands;
    return particles;
}

} // namespace

/// Early and late separation at forks (Strands 2024, figure 8).
class JoinedForksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void greaterAlpha_movesForksUp();
    void joinedNodes_keepTheStructure_data();
    void joinedNodes_keepTheStructure();
};

void JoinedForksTest::greaterAlpha_movesForksUp()
{
    int moved = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        TreeBuilder builder = raisedTree(800, seed);
        const std::uint64_t early = particlesOf(skeletonAt(builder, 2.5));
        const std::uint64_t middle = particlesOf(skeletonAt(builder, 30.0));
        const std::uint64_t late = particlesOf(skeletonAt(builder, 100.0));
        QVERIFY(early <= middle && middle <= late);
        moved += early < late ? 1 : 0;
    }
    QVERIFY(moved >= 5);
}

void JoinedForksTest::joinedNodes_keepTheStructure_data()
{
    QTest::addColumn<double>("alpha");
    for (const double alpha : {2.5, 6.0, 30.0, 100.0})
        QTest::addRow("%g", alpha) << alpha;
}

void JoinedForksTest::joinedNodes_keepTheStructure()
{
    QFETCH(double, alpha);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        TreeBuilder builder = raisedTree(600, seed);
        const StrandSkeleton apart = skeletonAt(builder, 2.5);
        const StrandSkeleton joined = skeletonAt(builder, alpha);
        // The same places of the tree, each once.
        std::set<std::pair<InternodeId, float>> places;
        for (const StrandNode& node : apart.nodes)
            places.emplace(node.internode, node.along);
        QCOMPARE(joined.nodes.size(), apart.nodes.size());
        for (const StrandNode& node : joined.nodes)
            QCOMPARE(places.erase({node.internode, node.along}), 1U);
        // Parents come first, and no strand is lost.
        for (std::uint32_t i = 0; i < joined.nodes.size(); ++i) {
            const StrandNode& node = joined.nodes[i];
            QVERIFY(node.parent < i || joined.isBase(i));
            QVERIFY(node.position.allFinite() && node.radius > 0.0F);
            std::uint32_t strands = 0;
            for (const std::uint32_t child : joined.childrenOf(i)) {
                QCOMPARE(joined.nodes[child].parent, i);
                QCOMPARE(joined.nodes[child].offset, strands);
                strands += joined.nodes[child].strands;
            }
            if (node.childCount > 0)
                QCOMPARE(node.strands, strands);
        }
        QCOMPARE(joined.nodes[joined.bases.front()].strands, apart.nodes[apart.bases.front()].strands);
    }
}

static const TestClass<JoinedForksTest> joinedForksTest;

} // namespace espalier::test

#include "JoinedForksTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/BranchMesher.h"

#include "model/mesh/TubeMesher.h"
#include "model/mesh/Tubes.h"
#include "model/mesh/WoodTracker.h"
#include "tests/support/MeshTopology.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <tbb/global_control.h>

namespace espalier::test {

class BranchMesherTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void mesh_ofASeedling_isOneTube();
    void mesh_isThatOfEachTubeInTurn();
    void mesh_ofTheWholeTree_isAClosedManifold();
    void mesh_isTheSameOnOneThreadAndMany();
    void mesh_ofADeadBranch_isGone();
    void wideNode_isDividedInTimeInProportionToItsChildren();
};

void BranchMesherTest::mesh_ofASeedling_isOneTube()
{
    const TreeBuilder seedling;
    const BranchMesh mesh =
        meshBranches(seedling.tree, seedling.index, Widths(seedling.tree, seedling.index));
    QCOMPARE(mesh.parts.size(), std::size_t{1});
    const MeshTopology topology = topologyOf(mesh.vertices, mesh.indices);
    QVERIFY(topology.isClosedManifold());
    QCOMPARE(topology.eulerCharacteristic, 2);
}

void BranchMesherTest::mesh_isThatOfEachTubeInTurn()
{
    const TreeBuilder builder = raisedTree(1500, 2);
    const Widths widths(builder.tree, builder.index);
    const BranchMesh mesh = meshBranches(builder.tree, builder.index, widths);
    const std::vector<InternodeId> tubes = tubesOf(builder.tree, builder.index);
    QCOMPARE(mesh.parts.size(), tubes.size());
    TubeMesher mesher(builder.tree, builder.index, widths);
    MeshSize done;
    for (std::size_t i = 0; i < tubes.size(); ++i) {
        const BranchMesh::Part& part = mesh.parts[i];
        QCOMPARE(part.base, tubes[i]);
        QCOMPARE(part.firstVertex, done.vertices);
        QCOMPARE(part.firstIndex, done.indices);
        const MeshSize size = mesher.prepare(part.base);
        QVERIFY(part.size == size);
        std::vector<MeshVertex> vertices(size.vertices);
        std::vector<VertexIndex> indices(size.indices);
        mesher.write(vertices, indices, part.firstVertex);
        QVERIFY(std::ranges::equal(vertices, std::span(mesh.vertices).subspan(done.vertices, size.vertices)));
        QVERIFY(std::ranges::equal(indices, std::span(mesh.indices).subspan(done.indices, size.indices)));
        done.vertices += size.vertices;
        done.indices += size.indices;
    }
    QCOMPARE(mesh.vertices.size(), std::size_t{done.vertices});
    QCOMPARE(mesh.indices.size(), std::size_t{done.indices});
}

void BranchMesherTest::mesh_ofTheWholeTree_isAClosedManifold()
{
    // Tubes touch in no vertex, so welding the whole tree joins nothing that should be apart.
    const TreeBuilder builder = raisedTree(3000, 3);
    const BranchMesh mesh = meshBranches(builder.tree, builder.index, Widths(builder.tree, builder.index));
    const MeshTopology topology = topologyOf(mesh.vertices, mesh.indices);
    QCOMPARE(topology.openEdges, 0);
    QCOMPARE(topology.nonManifoldEdges, 0);
    QCOMPARE(topology.degenerateTriangles, 0);
    QCOMPARE(topology.eulerCharacteristic, 2 * static_cast<int>(mesh.parts.size()));
}

void BranchMesherTest::mesh_isTheSameOnOneThreadAndMany()
{
    const TreeBuilder builder = raisedTree(12000, 4);
    const Widths widths(builder.tree, builder.index);
    BranchMesh single;
    {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        single = meshBranches(builder.tree, builder.index, widths);
    }
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    const BranchMesh many = meshBranches(builder.tree, builder.index, widths);
    QVERIFY(single.vertices == many.vertices);
    QVERIFY(single.indices == many.indices);
}

void BranchMesherTest::mesh_ofADeadBranch_isGone()
{
    TreeBuilder builder = raisedTree(400, 5);
    const BranchMesh before = meshBranches(builder.tree, builder.index, Widths(builder.tree, builder.index));
    const InternodeId pruned = builder.index.firstChild(builder.index.firstChild(0));
    builder.apply(death(builder.tree, builder.index, pruned));
    const BranchMesh after = meshBranches(builder.tree, builder.index, Widths(builder.tree, builder.index));
    QVERIFY(after.parts.size() < before.parts.size());
    for (const BranchMesh::Part& part : after.parts)
        QVERIFY(builder.tree.isAlive(part.base));
    builder.revert();
    const BranchMesh again = meshBranches(builder.tree, builder.index, Widths(builder.tree, builder.index));
    QVERIFY(again.vertices == before.vertices);
    QVERIFY(again.indices == before.indices);
}

void BranchMesherTest::wideNode_isDividedInTimeInProportionToItsChildren()
{
    constexpr std::uint32_t count = 60'000;
    TreeBuilder builder;
    WoodTracker tracker;
    tracker.restart(builder.tree, builder.index);
    const std::vector<NewInternode> fan(count, {.parent = 0, .slot = 0});
    QElapsedTimer clock;
    clock.start();
    tracker.follow(builder.tree, builder.index, builder.apply(births(builder.tree, fan)));
    QCOMPARE(tracker.take(builder.tree, builder.index, 2 * count).wood.size(), std::size_t{count});
    tracker.restart(builder.tree, builder.index);
    QCOMPARE(tracker.take(builder.tree, builder.index, 2 * count).wood.size(), std::size_t{count});
    QCOMPARE(tubesOf(builder.tree, builder.index).size(), std::size_t{count});
    // To visit all children of the node for each of them takes a hundred times as long.
    QVERIFY2(clock.elapsed() < 15'000, qPrintable(QStringLiteral("%1 ms").arg(clock.elapsed())));
}

const TestClass<BranchMesherTest> branchMesherTest;

} // namespace espalier::test

#include "BranchMesherTest.moc"

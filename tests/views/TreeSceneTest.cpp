// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/TreeScene.h"

#include "commands/SetParameters.h"
#include "model/document/PreparedTree.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class TreeSceneTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wood_isFinerWhereAPixelIsSmaller();
    void tolerance_doesNotWaverWithThePixel();
    void preparedScene_isShownAsItIs();
    void preparedScene_ofAnotherTree_isDropped();
    void strands_takeTheLeavesAlong();
    void fibres_areWantedWhereTheyShow();
};

void TreeSceneTest::wood_isFinerWhereAPixelIsSmaller()
{
    TreeDocument document;
    growAtRandom(document, 4, 200);
    TreeScene scene(document);
    std::size_t coarser = 0;
    for (const double pixel : {0.2, 0.005, 0.0003}) {
        scene.setPixelSize(pixel);
        scene.prepare();
        // An outline is off by less than a third of a pixel.
        QVERIFY(scene.mesh().options().tolerance < pixel / 3.0);
        const std::size_t vertices = scene.mesh().vertices().size();
        QVERIFY(vertices > coarser);
        coarser = vertices;
    }
}

void TreeSceneTest::tolerance_doesNotWaverWithThePixel()
{
    TreeDocument document;
    TreeScene scene(document);
    for (const double pixel : {1e-4, 3e-4, 1e-3, 5e-3, 0.02, 0.1}) {
        scene.setPixelSize(pixel);
        scene.prepare();
        const double tolerance = scene.mesh().options().tolerance;
        for (const double factor : {0.9, 1.1, 1.0}) {
            scene.setPixelSize(factor * pixel);
            QCOMPARE(scene.mesh().options().tolerance, tolerance);
            QVERIFY(!scene.isBehind());
        }
    }
    // An invalid size changes nothing.
    const double tolerance = scene.mesh().options().tolerance;
    for (const double pixel : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        scene.setPixelSize(pixel);
    QCOMPARE(scene.mesh().options().tolerance, tolerance);
}

void TreeSceneTest::strands_takeTheLeavesAlong()
{
    TreeDocument document;
    growAtRandom(document, 6, 300);
    TreeParameters parameters = document.parameters();
    parameters.leaves.visible = true;
    setParameters(document, parameters);
    TreeScene scene(document);
    connect(&document, &TreeDocument::changed, this, [&](const TreeChange& change) { scene.follow(change); });
    scene.prepare();
    const auto leaves = [&] {
        while (!scene.settleSome()) {
        }
        return std::vector<LeafInstance>(scene.mesh().leaves().begin(), scene.mesh().leaves().end());
    };
    const std::vector<LeafInstance> onTubes = leaves();
    parameters.wood.mesher = WoodMesherKind::Strands;
    setParameters(document, parameters);
    QVERIFY(scene.wantsStrands());
    QVERIFY(leaves() == onTubes); // as long as tubes are shown
    scene.prepareStrands();
    QVERIFY(!scene.wantsStrands());
    const std::vector<LeafInstance> onStrands = leaves();
    QCOMPARE(onStrands.size(), onTubes.size());
    QVERIFY(onStrands != onTubes);
    // Leaves of another shape stand on the same strands at once.
    parameters.leaves.length *= 0.5;
    setParameters(document, parameters);
    QVERIFY(scene.strands());
    const std::vector<LeafInstance> smaller = leaves();
    for (std::size_t i = 0; i < smaller.size(); ++i)
        QVERIFY(smaller[i].position == onStrands[i].position || smaller[i].length == 0.0F);
    QVERIFY(smaller != onStrands);
    // Tubes stand in for a tree that grows, and leaves stand on these.
    grow(document, 1);
    QVERIFY(!scene.strands());
    document.undo();
    parameters.leaves.length *= 2.0;
    setParameters(document, parameters);
    QVERIFY(leaves().size() >= onTubes.size());
    for (const LeafInstance& leaf : leaves())
        QVERIFY(leaf.length == 0.0F || std::ranges::find(onTubes, leaf) != onTubes.end());
    disconnect(&document, nullptr, this, nullptr);
}

void TreeSceneTest::fibres_areWantedWhereTheyShow()
{
    TreeDocument document;
    growAtRandom(document, 6, 300);
    TreeParameters parameters = document.parameters();
    parameters.wood.mesher = WoodMesherKind::Tubes;
    setParameters(document, parameters);
    TreeScene scene(document);
    QVERIFY(!scene.wantsStrands());
    scene.setFibresShown(true);
    QVERIFY(scene.wantsStrands());
    scene.prepareStrands();
    QVERIFY(!scene.wantsStrands());
    QVERIFY(!scene.strands()->fibres.empty());
    QVERIFY(!scene.strands()->hasMesh());
    scene.setFibresShown(false);
    QVERIFY(!scene.wantsStrands());
}

void TreeSceneTest::preparedScene_isShownAsItIs()
{
    TreeDocument grown;
    growAtRandom(grown, 4, 200);
    PreparedTree tree(grown.tree(), grown.journal());
    PreparedScene prepared(tree.tree, tree.index, tree.growthModel->space());
    const MeshVertex* const vertices = prepared.mesh.vertices().data();

    TreeDocument document;
    TreeScene scene(document);
    connect(&document, &TreeDocument::changed, this,
            [&scene](const TreeChange& change) { scene.follow(change); });
    scene.expect(std::move(prepared));
    document.reset(std::move(tree));
    QCOMPARE(scene.mesh().vertices().data(), vertices);
}

void TreeSceneTest::preparedScene_ofAnotherTree_isDropped()
{
    TreeDocument grown;
    growAtRandom(grown, 4, 200);
    const PreparedTree tree(grown.tree(), grown.journal());
    PreparedScene prepared(tree.tree, tree.index, tree.growthModel->space());

    TreeDocument document;
    TreeScene scene(document);
    const std::size_t vertices = scene.mesh().vertices().size();
    connect(&document, &TreeDocument::changed, this,
            [&scene](const TreeChange& change) { scene.follow(change); });
    scene.expect(std::move(prepared));
    document.reset(1);
    QCOMPARE(scene.mesh().vertices().size(), vertices);
}

const TestClass<TreeSceneTest> treeSceneTest;

} // namespace espalier::test

#include "TreeSceneTest.moc"

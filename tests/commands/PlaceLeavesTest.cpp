// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/PlaceLeaves.h"

#include "commands/Prune.h"
#include "model/tree/PlacedLeafIndex.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/PlacedLeaves.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>

namespace espalier::test {

class PlaceLeavesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void leaf_isOneUndoStep_undoneAndRedoneToTheBit();
    void leaf_thatCannotBe_isRefused();
    void signOfZeros_doesNotCount();
    void prunedWood_takesItsLeavesAlong();
    void arrangement_isOneUndoStep_undoneAndRedoneToTheBit();
    void arrangement_withoutSamples_isRefused();
    void recipe_givesTheSameDocument();
};

namespace {

/// The youngest living internode that is not the seedling.
InternodeId youngest(const Tree& tree)
{
    InternodeId id = tree.size() - 1;
    while (id > 1 && !tree.isAlive(id))
        --id;
    return id;
}

/// An internode of the trunk, a third of its internodes from the ground.
InternodeId thirdOfTrunk(const TreeIndex& index)
{
    std::vector<InternodeId> trunk;
    for (InternodeId id = 0; id != kNoInternode; id = index.mainChild(id))
        trunk.push_back(id);
    return trunk[trunk.size() / 3];
}

} // namespace

void PlaceLeavesTest::leaf_isOneUndoStep_undoneAndRedoneToTheBit()
{
    TreeDocument document;
    growAtRandom(document, 3, 120);
    const DocumentState before(document);
    const int steps = document.undoStack().count();
    const InternodeId carrier = youngest(document.tree());
    LeafRow leaf = leafAround(carrier, 0.25F, 1.0, 0.12F);
    leaf.kind = LeafKind::Fruit;
    QVERIFY(placeLeaf(document, leaf));
    QCOMPARE(document.undoStack().count(), steps + 1);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Place Leaf"));
    QCOMPARE(document.tree().placedLeaves().size(), 1U);
    const LeafRow placed = leafRow(document.tree(), 0);
    QCOMPARE(placed.internode, carrier);
    QCOMPARE(placed.along, 0.25F);
    QCOMPARE(placed.length, 0.12F);
    QVERIFY(placed.kind == LeafKind::Fruit && placed.rotation == leaf.rotation);
    QCOMPARE(placed.birth, document.tree().step());
    const DocumentState after(document);
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());
    document.redo();
    QCOMPARE(differenceFrom(after, document), QString());
}

void PlaceLeavesTest::leaf_thatCannotBe_isRefused()
{
    TreeDocument document;
    growAtRandom(document, 3, 60);
    const DocumentState before(document);
    QVERIFY(!placeLeaf(document, leafAround(document.tree().size(), 0.5F, 0.0)));
    QVERIFY(!placeLeaf(document, leafAround(0, 1.5F, 0.0)));
    QVERIFY(!placeLeaf(document, leafAround(0, 0.5F, 0.0, 0.0F)));
    QVERIFY(!placeLeaf(document, leafAround(0, 0.5F, 0.0, 0.5F * kSmallestLeaf)));
    QVERIFY(!placeLeaf(document, leafAround(0, 0.5F, 0.0, std::numeric_limits<float>::quiet_NaN())));
    QCOMPARE(differenceFrom(before, document), QString());
}

void PlaceLeavesTest::signOfZeros_doesNotCount()
{
    TreeDocument document;
    QVERIFY(placeLeaf(document, leafAt(0, -0.0F, Rotation(1.0F, -0.0F, -0.0F, -0.0F), 0.1F)));
    const LeafRow leaf = leafRow(document.tree(), 0);
    QVERIFY(!std::signbit(leaf.along) && !std::signbit(leaf.rotation.x()));
    QCOMPARE(replayFault(document), QString());
}

void PlaceLeavesTest::prunedWood_takesItsLeavesAlong()
{
    TreeDocument document;
    growAtRandom(document, 3, 120);
    const InternodeId carrier = youngest(document.tree());
    QVERIFY(placeLeaf(document, leafAround(carrier, 0.5F, 0.0)));
    QCOMPARE(placedLeafCount(document.tree()), std::uint64_t{1});
    pruneBranches(document, std::array{carrier});
    QCOMPARE(placedLeafCount(document.tree()), std::uint64_t{0});
    document.undo();
    QCOMPARE(placedLeafCount(document.tree()), std::uint64_t{1});
}

void PlaceLeavesTest::arrangement_isOneUndoStep_undoneAndRedoneToTheBit()
{
    for (const LeafEngine engine :
         {LeafEngine::AddToWhorl, LeafEngine::Alternate, LeafEngine::Opposite, LeafEngine::Decussate}) {
        TreeDocument document;
        growAtRandom(document, 5, 200);
        QVERIFY(placeLeaf(document, leafAround(0, 0.2F, 0.0)));
        const InternodeId above = thirdOfTrunk(document.index());
        QVERIFY(above != 0);
        QVERIFY(placeLeaf(document, leafAround(above, 0.9F, 2.0)));
        const DocumentState before(document);
        QVERIFY(arrangeLeaves(document, engine, {above, 0.9F}));
        QVERIFY(document.tree().placedLeaves().size() > 2);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Arrange Leaves"));
        const DocumentState after(document);
        document.undo();
        QCOMPARE(differenceFrom(before, document), QString());
        document.redo();
        QCOMPARE(differenceFrom(after, document), QString());
        QCOMPARE(replayFault(document), QString());
    }
}

void PlaceLeavesTest::arrangement_withoutSamples_isRefused()
{
    TreeDocument document;
    growAtRandom(document, 5, 100);
    const DocumentState before(document);
    for (const LeafEngine engine : kLeafEngines)
        QVERIFY(!arrangeLeaves(document, engine, {0, 0.5F}));
    QVERIFY(!arrangeLeaves(document, LeafEngine::AddToWhorl, {document.tree().size(), 0.5F}));
    QCOMPARE(differenceFrom(before, document), QString());
}

void PlaceLeavesTest::recipe_givesTheSameDocument()
{
    TreeDocument document;
    brush(document, strokeAlong(std::array{Vec3(Vec3::Zero()), Vec3(0.2F, 1.5F, 0.0F)}, 0.0F, 1.5));
    QVERIFY(placeLeaf(document, leafAround(3, 0.123F, 0.3, 0.077F)));
    QVERIFY(placeLeaf(document, leafAround(3, 0.123F, 2.3, 0.08F)));
    QVERIFY(arrangeLeaves(document, LeafEngine::AddToWhorl, {3, 0.1F}));
    QVERIFY(placeLeaf(document, leafAround(5, 0.5F, 2.9)));
    QVERIFY(arrangeLeaves(document, LeafEngine::ExtendWhorls, {5, 0.5F}));
    grow(document, 2);
    pruneBranches(document, std::array{InternodeId{6}});
    QCOMPARE(replayFault(document), QString());
}

const TestClass<PlaceLeavesTest> placeLeavesTest;

} // namespace espalier::test

#include "PlaceLeavesTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/PlacedLeaves.h"

#include "model/io/export/ExportScene.h"
#include "model/mesh/LeafCard.h"
#include "model/mesh/LeafPlacer.h"
#include "model/mesh/TreeCounts.h"
#include "model/mesh/WoodMesh.h"
#include "tests/support/Leaves.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

/// Leaves that the user has placed, as they are shown.
class PlacedLeavesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void placedLeaf_hasTheFrameAndTheLengthOfItsRow();
    void placedLeaf_standsOnTheBarkOnItsSide();
    void placedLeaf_ofStrands_standsOnThem();
    void placedLeaf_looksLikeLeavesByRule();
    void placedLeaves_goAndComeWithTheirInternode();
    void placedLeaves_standBesideLeavesByRule();
    void placedLeaves_areHiddenWithTheOthers();
    void placedLeaves_keepTheirHueWhileTheyMove();
    void counts_andBounds_haveThem();
    void exportedMesh_hasThem();
};

namespace {

/// Parameters without leaves by rule.
TreeParameters placedAlone()
{
    TreeParameters parameters;
    parameters.leaves.perNode = 0;
    return parameters;
}

Rotation frameOf(const LeafInstance& leaf)
{
    return Rotation(leaf.rotation[3], leaf.rotation[0], leaf.rotation[1], leaf.rotation[2]);
}

/// A leaning axis of ten internodes on the seedling.
TreeBuilder leaningAxis(const TreeParameters& parameters)
{
    TreeBuilder builder(1, parameters);
    builder.growAxis(0, kTerminalSlot, continuing(0.5), 10, continuing(0.1));
    return builder;
}

void place(TreeBuilder& builder, const LeafRow& leaf)
{
    TreeDelta delta = deltaStartingAt(builder.tree);
    addLeaf(delta, leaf);
    builder.apply(std::move(delta));
}

} // namespace

void PlacedLeavesTest::placedLeaf_hasTheFrameAndTheLengthOfItsRow()
{
    TreeBuilder builder = leaningAxis(placedAlone());
    Random random(1, 0, 0, Purpose::Direction);
    for (InternodeId id = 1; id < 10; ++id)
        place(builder, leafAt(id, 0.5F, Rotation(Eigen::AngleAxisf(2.0F, random.direction())),
                              0.01F * static_cast<float>(id)));
    const MeshBuffer<LeafInstance> leaves = leavesOf(builder);
    QCOMPARE(leaves.size(), std::size_t{9});
    for (const LeafInstance& leaf : leaves) {
        const auto row = std::ranges::find(builder.tree.placedLeaves().length, leaf.length) -
                         builder.tree.placedLeaves().length.begin();
        QVERIFY(row < 9);
        const Rotation wanted = placedLeafFrame(builder.tree, builder.index, static_cast<LeafId>(row));
        QVERIFY(frameOf(leaf).angularDistance(wanted) < 1e-3F);
        QCOMPARE(leaf.width, leaf.length * static_cast<float>(builder.tree.parameters().leaves.aspect));
    }
}

void PlacedLeavesTest::placedLeaf_standsOnTheBarkOnItsSide()
{
    TreeBuilder builder = leaningAxis(placedAlone());
    builder.apply(widthChange(builder.tree, 5, 0.08F));
    const Widths widths(builder.tree, builder.index);
    for (const double azimuth : {0.0, 1.0, 3.0, 5.0})
        place(builder, leafAround(5, 0.25F, azimuth));
    place(builder, leafAt(5, 0.25F, Rotation::Identity(), 0.1F)); // along the wood
    const MeshBuffer<LeafInstance> leaves = leavesOf(builder);
    QCOMPARE(leaves.size(), std::size_t{5});
    const Vec3 middle = placedLeafBase(builder.tree, builder.index, 0);
    const float radius = widths.radius(builder.index, 5);
    QVERIFY(radius > 0.03F);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 out = toVec3(leaves[i].position) - middle;
        QVERIFY(std::abs(out.norm() - radius) < 1e-4F);
        QVERIFY((out.normalized() - frameOf(leaves[i]) * Vec3(Vec3::UnitY())).norm() < 1e-3F);
    }
    QVERIFY((toVec3(leaves[4].position) - middle).norm() < 1e-5F);
}

void PlacedLeavesTest::placedLeaf_ofStrands_standsOnThem()
{
    TreeParameters parameters = placedAlone();
    parameters.wood.mesher = WoodMesherKind::Strands;
    TreeBuilder builder = leaningAxis(parameters);
    builder.growAxis(4, 0, branching(0.9), 8);
    for (InternodeId id = 2; id < builder.tree.size(); ++id)
        place(builder, leafAround(id, 0.5F, id));
    const Widths widths(builder.tree, builder.index);
    const ShownWood wood(builder.tree, builder.index, widths);
    const StrandLines lines = wood.lines();
    const MeshBuffer<LeafInstance> leaves = wood.leaves();
    QCOMPARE(leaves.size(), std::size_t{builder.tree.size() - 2});
    for (const LeafInstance& leaf : leaves) {
        const Vec3 position = toVec3(leaf.position);
        const bool isOnBark = std::ranges::any_of(lines, [&](const WoodLine& line) {
            const Vec3 offset = position - line.lower;
            const float along = offset.dot(line.axis);
            const float off = (offset - along * line.axis).norm();
            return line.radius > 0.0F && along > -1e-4F && along < (line.upper - line.lower).norm() + 1e-4F &&
                   std::abs(off - line.radius) < 0.02F * line.radius + 1e-5F;
        });
        QVERIFY(isOnBark);
    }
}

void PlacedLeavesTest::placedLeaf_looksLikeLeavesByRule()
{
    TreeParameters parameters;
    parameters.leaves.shape = LeafShape::Ovate;
    parameters.leaves.hueVariation = 0.0;
    TreeBuilder builder = leaningAxis(parameters);
    const InternodeId tip = 10;
    place(builder, leafAround(tip, 1.0F, 0.5, 0.33F));
    const std::vector<LeafInstance> byRule = leavesOf(builder, tip);
    const MeshBuffer<LeafInstance> all = leavesOf(builder);
    const auto placed = std::ranges::find(all, 0.33F, &LeafInstance::length);
    QVERIFY(placed != all.end());
    QCOMPARE(placed->shape, byRule.front().shape);
    QCOMPARE(placed->hueShift, byRule.front().hueShift);
    QCOMPARE(placed->value, byRule.front().value);
}

void PlacedLeavesTest::placedLeaves_goAndComeWithTheirInternode()
{
    TreeBuilder builder = leaningAxis(placedAlone());
    place(builder, leafAround(3, 0.5F, 0.0));
    place(builder, leafAround(8, 0.5F, 0.0));
    const MeshBuffer<LeafInstance> both = leavesOf(builder);
    QCOMPARE(both.size(), std::size_t{2});
    builder.apply(death(builder.tree, builder.index, 6));
    QCOMPARE(leavesOf(builder).size(), std::size_t{1});
    builder.revert();
    QVERIFY(std::ranges::equal(leavesOf(builder), both));
}

void PlacedLeavesTest::placedLeaves_standBesideLeavesByRule()
{
    TreeBuilder builder = raisedTree(300, 4);
    const MeshBuffer<LeafInstance> byRule = leavesOf(builder);
    QVERIFY(!byRule.empty());
    Random random(3, 0, 0, Purpose::Direction);
    for (int i = 0; i < 60; ++i)
        builder.apply(randomLeafEdit(builder.tree, random));
    const MeshBuffer<LeafInstance> all = leavesOf(builder);
    QVERIFY(placedLeafCount(builder.tree) > 10);
    QCOMPARE(all.size(), byRule.size() + placedLeafCount(builder.tree));
    for (const LeafInstance& leaf : byRule)
        QVERIFY(std::ranges::find(all, leaf) != all.end());
}

void PlacedLeavesTest::placedLeaves_areHiddenWithTheOthers()
{
    TreeParameters parameters = placedAlone();
    parameters.leaves.visible = false;
    TreeBuilder builder = leaningAxis(parameters);
    place(builder, leafAround(3, 0.5F, 0.0));
    QVERIFY(leavesOf(builder).empty());
    QCOMPARE(countTree(builder.tree, builder.index).leavesPlaced, std::uint64_t{0});
}

void PlacedLeavesTest::placedLeaves_keepTheirHueWhileTheyMove()
{
    TreeParameters parameters = placedAlone();
    parameters.leaves.hueVariation = 0.2;
    TreeBuilder builder = leaningAxis(parameters);
    for (const float along : {0.2F, 0.5F, 0.8F})
        place(builder, leafAround(4, along, 0.0));
    const MeshBuffer<LeafInstance> before = leavesOf(builder);
    QVERIFY(before[0].hueShift != before[1].hueShift && before[1].hueShift != before[2].hueShift);
    TreeDelta delta = deltaStartingAt(builder.tree);
    moveLeaf(delta, builder.tree, 1, leafAround(4, 0.6F, 2.0, 0.3F));
    builder.apply(std::move(delta));
    builder.apply(leafRemoval(builder.tree, 0));
    const MeshBuffer<LeafInstance> after = leavesOf(builder);
    QCOMPARE(after.size(), std::size_t{2});
    QCOMPARE(after[0].hueShift, before[1].hueShift);
    QCOMPARE(after[1].hueShift, before[2].hueShift);
}

void PlacedLeavesTest::counts_andBounds_haveThem()
{
    TreeBuilder builder = raisedTree(200, 4);
    const TreeCounts before = countTree(builder.tree, builder.index);
    QCOMPARE(before.leavesPlaced, std::uint64_t{0});
    place(builder,
          leafAt(0, 0.5F, Rotation(Eigen::AngleAxisf(-0.5F * std::numbers::pi_v<float>, Vec3::UnitZ())),
                 50.0F));
    const TreeCounts after = countTree(builder.tree, builder.index);
    QCOMPARE(after.leavesPlaced, std::uint64_t{1});
    QCOMPARE(after.leaves, before.leaves + 1);
    const Box3 bounds = treeBounds(builder.tree, builder.index);
    QVERIFY(bounds.max().x() - bounds.min().x() > 49.0F);
}

void PlacedLeavesTest::exportedMesh_hasThem()
{
    TreeBuilder builder = leaningAxis(placedAlone());
    const ExportOptions small{.textureSize = 64};
    QCOMPARE(buildExportScene(builder.tree, builder.index, {}, small).meshes.size(), std::size_t{1});
    place(builder, leafAround(3, 0.5F, 0.0));
    place(builder, leafAround(6, 0.5F, 2.0, 0.2F));
    const ExportScene scene = buildExportScene(builder.tree, builder.index, {}, small);
    QCOMPARE(scene.meshes.size(), std::size_t{2});
    const TriangleMesh expected = expandLeaves(leavesOf(builder));
    QCOMPARE(scene.meshes[1].mesh.vertices.size(), expected.vertices.size());
    for (std::size_t i = 0; i < expected.vertices.size(); ++i)
        QVERIFY(scene.meshes[1].mesh.vertices[i].position == expected.vertices[i].position);
}

const TestClass<PlacedLeavesTest> placedLeavesTest;

} // namespace espalier::test

#include "PlacedLeavesTest.moc"

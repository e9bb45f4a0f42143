// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/SketchSkeleton.h"

#include "commands/DrawSketch.h"
#include "commands/ImportSkeleton.h"
#include "model/shape/Widths.h"
#include "model/tree/PlacedLeafIndex.h"
#include "tests/model/sketch/DrawnTrees.h"
#include "tests/support/Documents.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier::test {

class SketchSkeletonTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void internodes_followTheCurves();
    void sidesOfATrunk_becomeItsWidth();
    void hugeSketch_hasABoundedNumberOfPieces();
    void emptySketch_hasNoPieces();
    void drawnSketch_isOneUndoStepAndARecipe();
    void drawnSketch_endsWhereItsStrokesDo();
    void drawnLeaves_becomePlacedLeaves_data();
    void drawnLeaves_becomePlacedLeaves();
    void sketchWithoutABranch_isRefused();
};

namespace {

/// What a recipe holds of a drawn tree.
TreeSketch sketchOf(const std::vector<SketchStroke>& strokes)
{
    TreeSketch sketch;
    for (const SketchStroke& stroke : strokes) {
        std::vector<Vec2>& points = sketch.strokes.emplace_back();
        for (const Eigen::Vector2d& point : stroke.line)
            points.emplace_back(point.cast<float>());
    }
    return sketch;
}

} // namespace

void SketchSkeletonTest::internodes_followTheCurves()
{
    const PlacedTree placed = inferDepth(SketchedTree::ofStrokes(drawnTree(1, 30)));
    const Skeleton skeleton = skeletonOf(placed, 0.1);
    TreeDocument document;
    const Result<void> imported = importSkeleton(document, skeleton);
    QVERIFY2(imported, imported ? "" : qPrintable(imported.error().message));
    QCOMPARE(treeFault(document.tree().content()), QString());
    QCOMPARE(indexFault(document), QString());
    QCOMPARE(document.index().livingCount(), static_cast<std::uint32_t>(skeleton.size()));
    for (const SkeletonSegment& segment : skeleton)
        QVERIFY((segment.tip - segment.base).norm() < 0.16F);
    // Both ends of each branch are there, up to what a curve is beside the chord of a piece.
    const Vec3 foot = skeleton.front().base;
    for (const PlacedBranch& branch : placed.branches) {
        const Vec3 tip = branch.line.back().cast<float>() - foot;
        const Vec3 base = branch.line.front().cast<float>() - foot;
        float atTip = std::numeric_limits<float>::infinity();
        float atBase = atTip;
        for (InternodeId id = 0; id < skeleton.size(); ++id) {
            atTip = std::min(atTip, (document.index().nodePosition(id) - tip).norm());
            atBase = std::min(atBase, (document.index().basePosition(document.tree(), id) - base).norm());
        }
        QVERIFY(atTip < 1e-4F);
        QVERIFY(atBase < 0.005F);
    }
}

void SketchSkeletonTest::sidesOfATrunk_becomeItsWidth()
{
    const std::vector<SketchStroke> strokes{openStroke({{-0.2, 0.0}, {-0.1, 4.0}}),
                                            openStroke({{0.2, 0.0}, {0.1, 4.0}}),
                                            openStroke({{0.0, 2.0}, {2.0, 3.0}})};
    const Skeleton skeleton = skeletonOf(inferDepth(SketchedTree::ofStrokes(strokes)), 1.0);
    QCOMPARE(skeleton.size(), std::size_t{4 + 2 + 2});
    QVERIFY(std::abs(skeleton[0].radius - 0.175F) < 1e-6F);
    QVERIFY(std::abs(skeleton[3].radius - 0.1F) < 1e-6F);
    QCOMPARE(skeleton[4].radius, 0.0F);
    QVERIFY(skeleton[4].parent == 1U || skeleton[4].parent == 2U); // It begins where they meet
    QCOMPARE(skeleton[5].parent, 4U);
    TreeDocument document;
    QVERIFY(importSkeleton(document, skeleton));
    const Widths widths(document.tree(), document.index());
    QVERIFY(std::abs(widths.radius(document.index(), 0) - 0.175F) < 1e-5F);
}

void SketchSkeletonTest::hugeSketch_hasABoundedNumberOfPieces()
{
    SketchedTree drawn;
    drawn.attach(openStroke({{0.0, 0.0}, {0.0, 1e6}}));
    const Skeleton skeleton = skeletonOf(inferDepth(drawn), 0.005);
    QVERIFY(skeleton.size() > kMostSegments / 2);
    QVERIFY(skeleton.size() <= kMostSegments);
}

void SketchSkeletonTest::emptySketch_hasNoPieces()
{
    QVERIFY(skeletonOf({}, 0.1).empty());
}

void SketchSkeletonTest::drawnSketch_isOneUndoStepAndARecipe()
{
    TreeDocument document;
    const DocumentState before(document);
    TreeSketch sketch = sketchOf(drawnTree(2, 12));
    sketch.strokes.front().front() = Vec2(-0.0F, 0.0F);
    sketch.depth.seed = 5;
    QVERIFY(drawSketch(document, sketch));
    QVERIFY(document.index().livingCount() > 100);
    QCOMPARE(replayFault(document), QString());
    const DocumentState after(document);
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());
    document.redo();
    QCOMPARE(differenceFrom(after, document), QString());
    // A second drawing has no seedling to begin from.
    const Result<void> again = drawSketch(document, sketch);
    QVERIFY(!again);
    QCOMPARE(again.error().message,
             QStringLiteral("a sketch can only become a tree where nothing has grown"));
    QCOMPARE(differenceFrom(after, document), QString());
}

void SketchSkeletonTest::drawnSketch_endsWhereItsStrokesDo()
{
    const TreeSketch sketch = sketchOf({openStroke(bentLine({1.0, 0.0}, 1.5, 4.0, 0.3, 30)),
                                        openStroke(bentLine({1.1, 1.6}, 0.8, 1.5, 0.5, 20)),
                                        openStroke(bentLine({1.0, 2.4}, 2.2, 1.2, -0.5, 20)),
                                        openStroke(bentLine({1.7, 2.2}, 0.1, 0.8, 0.6, 15))});
    TreeDocument document;
    QVERIFY(drawSketch(document, sketch));
    const Vec2 foot = sketch.strokes.front().front();
    for (const std::vector<Vec2>& stroke : sketch.strokes) {
        float nearest = std::numeric_limits<float>::infinity();
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            const Vec2 front = document.index().nodePosition(id).head<2>();
            nearest = std::min(nearest, (front - (stroke.back() - foot)).norm());
        }
        QVERIFY(nearest < 1e-4F);
    }
}

void SketchSkeletonTest::drawnLeaves_becomePlacedLeaves_data()
{
    QTest::addColumn<bool>("secondTree");
    QTest::newRow("one tree") << false;
    QTest::newRow("two trees") << true;
}

void SketchSkeletonTest::drawnLeaves_becomePlacedLeaves()
{
    QFETCH(const bool, secondTree);
    // A trunk, a limb to the right, and the outlines of a leaf on each.
    TreeSketch sketch =
        sketchOf({openStroke({{0.0, 0.0}, {0.0, 3.0}}), openStroke({{0.0, 1.5}, {1.5, 2.5}})});
    const auto leafFrom = [&](const Vec2& base, const Vec2& tip) {
        const Vec2 side = 0.2F * Vec2(base.y() - tip.y(), tip.x() - base.x());
        std::vector<Vec2>& stroke = sketch.strokes.emplace_back();
        for (int i = 0; i <= 40; ++i) {
            const float angle = static_cast<float>(i) / 40.0F * 2.0F * std::numbers::pi_v<float>;
            const Vec2 middle = 0.5F * (base + tip);
            stroke.emplace_back(middle + 0.5F * std::cos(angle) * (base - tip) + std::sin(angle) * side);
        }
    };
    leafFrom({-0.02F, 2.5F}, {-0.4F, 2.8F});
    leafFrom({0.9F, 2.12F}, {0.8F, 2.6F});
    sketch.depth.secondTree = secondTree;
    TreeDocument document;
    const DocumentState before(document);
    QVERIFY(drawSketch(document, sketch));
    QCOMPARE(treeFault(document.tree().content()), QString());
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    // The second tree has no trunk, so only the limb's leaf is there twice.
    QCOMPARE(tree.placedLeaves().size(), secondTree ? 3U : 2U);
    int fromTheFront = 0;
    for (LeafId leaf = 0; leaf < tree.placedLeaves().size(); ++leaf) {
        const Vec3 base = placedLeafBase(tree, index, leaf);
        const Rotation frame = placedLeafFrame(tree, index, leaf);
        const Vec3 tip = base + tree.placedLeaves().length[leaf] * (frame * Vec3(Vec3::UnitY()));
        const Vec3 upper = frame * Vec3(Vec3::UnitZ());
        QCOMPARE(tree.placedLeaves().birth[leaf], tree.step());
        const bool isFirst = upper.z() > 0.99F;
        fromTheFront += isFirst ? 1 : 0;
        if (!isFirst) {
            QVERIFY((upper + Vec3(Vec3::UnitX())).norm() < 0.01F);
            continue;
        }
        // From the front, base and tip are where they were drawn.
        const Vec2 drawnBase = base.x() < 0.5F ? Vec2(0.0F, 2.5F) : Vec2(0.9F, 2.1F);
        const Vec2 drawnTip = base.x() < 0.5F ? Vec2(-0.4F, 2.8F) : Vec2(0.8F, 2.6F);
        QVERIFY((base.head<2>() - drawnBase).norm() < 0.08F);
        QVERIFY((tip.head<2>() - drawnTip).norm() < 0.08F);
    }
    QCOMPARE(fromTheFront, 2);
    QCOMPARE(replayFault(document), QString());
    const DocumentState after(document);
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());
    document.redo();
    QCOMPARE(differenceFrom(after, document), QString());
}

void SketchSkeletonTest::sketchWithoutABranch_isRefused()
{
    TreeDocument document;
    const DocumentState before(document);
    for (const auto& strokes : {std::vector<std::vector<Vec2>>{{{1.0F, 2.0F}}},
                                std::vector<std::vector<Vec2>>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}}}) {
        const Result<void> drawn = drawSketch(document, {.strokes = strokes});
        QVERIFY(!drawn);
        QCOMPARE(drawn.error().message, QStringLiteral("no stroke of the sketch is a branch"));
        QCOMPARE(differenceFrom(before, document), QString());
    }
}

const TestClass<SketchSkeletonTest> sketchSkeletonTest;

} // namespace espalier::test

#include "SketchSkeletonTest.moc"

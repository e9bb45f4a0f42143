// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SketchStroke.h"

#include "commands/DocumentProject.h"
#include "commands/InferDepth.h"
#include "commands/PlaceLeaves.h"
#include "commands/PropagateBranch.h"
#include "commands/Prune.h"
#include "model/io/project/ProjectFile.h"
#include "model/sketch/FlatTree.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

/// Strokes that become branches, and the depth that a drawn tree gets.
class SketchStrokeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void firstStroke_isTheTrunk();
    void stroke_joinsTheNearestBranch();
    void tip_isWhereItWasDrawn();
    void stroke_fromATip_continuesTheBranch();
    void curve_isFollowed();
    void radii_becomeWidths();
    void replacedBranch_isGone();
    void replacedTrunk_standsOnItsOwnFoot();
    void mirrorImage_growsOnTheOtherSide();
    void replacedMirrorImage_isGone();
    void strokesWithoutLength_areRefused();
    void depth_keepsTheFrontView();
    void depth_givesASecondTree();
    void depth_givesTheSecondTreeItsLeaves();
    void depth_isRefusedWhereThereIsSome();
    void depthTrial_replacesTheLastOne();
    void trunkDrawnAgain_canBeSaved();
    void depthOfCopiedTwigs_canBeSaved();
    void depthBeyondTheLimits_isRefused();
    void drawnTree_growsOn();
    void growth_keepsWhatWasDrawn();
};

namespace {

LassoStroke strokeOf(std::vector<Vec2> points, const Vec3& origin = Vec3::Zero())
{
    return {origin, Vec3::UnitX(), Vec3::UnitY(), std::move(points)};
}

InternodeId draw(TreeDocument& document, std::vector<Vec2> points)
{
    const Result<InternodeId> first =
        sketchBranch(document, {.stroke = strokeOf(std::move(points)), .base = {}});
    return first ? *first : kNoInternode;
}

LeafRow leafAt(InternodeId id)
{
    LeafRow leaf;
    leaf.internode = id;
    leaf.rotation = Rotation::Identity();
    leaf.length = 0.1F;
    return leaf;
}

/// What is wrong with the document's file; empty if it can be written and read.
QString fileFault(const TreeDocument& document)
{
    const Result<QByteArray> packed = packProject(projectOf(document, QStringLiteral("drawn")));
    if (!packed)
        return packed.error().message;
    const Result<Project> read = unpackProject(*packed);
    return read ? QString() : read.error().message;
}

/// The last internode of a branch.
InternodeId tipOf(const TreeDocument& document, InternodeId id)
{
    while (document.index().mainChild(id) != kNoInternode)
        id = document.index().mainChild(id);
    return id;
}

Vec3 placeOf(const TreeDocument& document, InternodeId id)
{
    return document.index().nodePosition(id);
}

/// A trunk, limbs, and branches on limbs.
void drawTree(TreeDocument& document)
{
    draw(document, {{0.0F, 0.0F}, {0.1F, 1.5F}, {0.0F, 3.0F}});
    for (int i = 0; i < 8; ++i) {
        const float height = 0.8F + 0.25F * static_cast<float>(i);
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        draw(document, {{0.05F * side, height}, {0.5F * side, height + 0.4F}, {1.1F * side, height + 0.5F}});
        draw(document, {{0.6F * side, height + 0.42F}, {0.9F * side, height + 0.9F}});
    }
}

} // namespace

void SketchStrokeTest::firstStroke_isTheTrunk()
{
    TreeDocument document;
    const DocumentState before(document);
    // Drawn from above, and it stops short of the ground.
    QCOMPARE(draw(document, {{0.5F, 2.0F}, {0.4F, 1.0F}, {0.4F, 0.05F}}), 0U);
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY((document.tree().rootPosition(0) - Vec3(0.4F, 0.0F, 0.0F)).norm() < 1e-6F);
    QVERIFY((placeOf(document, tipOf(document, 0)) - Vec3(0.5F, 2.0F, 0.0F)).norm() < 1e-5F);
    QVERIFY(isFlat(document.tree(), document.index()));
    const DocumentState after(document);
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());
    document.redo();
    QCOMPARE(differenceFrom(after, document), QString());
}

void SketchStrokeTest::stroke_joinsTheNearestBranch()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    // Its end is nearer to the trunk than its beginning.
    const InternodeId first = draw(document, {{1.0F, 1.8F}, {0.1F, 1.23F}});
    const Tree& tree = document.tree();
    QCOMPARE(document.index().axis(tree.parent(first)), 0U);
    const Vec3 base = document.index().basePosition(tree, first);
    QVERIFY(std::abs(base.x()) < 1e-5F && std::abs(base.y() - 1.23F) < 1e-4F);
    QVERIFY(tree.columns().along[first] < 1.0F);
    const InternodeId second = draw(document, {{0.7F, 1.65F}, {0.8F, 2.4F}});
    QCOMPARE(document.index().axis(tree.parent(second)), first);
}

void SketchStrokeTest::tip_isWhereItWasDrawn()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    const InternodeId first = draw(document, {{0.2F, 1.0F}, {0.6F, 1.1F}, {1.0F, 1.6F}});
    QVERIFY((placeOf(document, tipOf(document, first)) - Vec3(1.0F, 1.6F, 0.0F)).norm() < 1e-5F);
}

void SketchStrokeTest::stroke_fromATip_continuesTheBranch()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    const InternodeId tip = tipOf(document, 0);
    const InternodeId first = draw(document, {{0.01F, 2.01F}, {0.3F, 2.8F}});
    QCOMPARE(document.tree().parent(first), tip);
    QVERIFY(document.tree().continuesAxis(first));
    QVERIFY((document.tree().buds(tip) & kTerminalBud) == 0);
}

void SketchStrokeTest::curve_isFollowed()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    std::vector<Vec2> curl;
    for (int i = 0; i <= 200; ++i) {
        const double angle = 0.06 * i;
        const double radius = 0.6 - 0.0025 * i;
        curl.emplace_back(static_cast<float>(0.6 - radius * std::cos(angle)),
                          static_cast<float>(1.0 + radius * std::sin(angle)));
    }
    InternodeId id = draw(document, curl);
    std::vector<Vec3> nodes{document.index().basePosition(document.tree(), id)};
    for (; id != kNoInternode; id = document.index().mainChild(id))
        nodes.push_back(placeOf(document, id));
    float farthest = 0.0F;
    for (const Vec2& point : curl) {
        float nearest = 10.0F;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const Vec2 from = nodes[i - 1].head<2>();
            const Vec2 edge = nodes[i].head<2>() - from;
            const float share = std::clamp((point - from).dot(edge) / edge.squaredNorm(), 0.0F, 1.0F);
            nearest = std::min(nearest, (point - from - share * edge).norm());
        }
        farthest = std::max(farthest, nearest);
    }
    // 0.0007 of the tree's size, and float lines.
    QVERIFY2(farthest < 0.002F, qPrintable(QString::number(double{farthest})));
}

void SketchStrokeTest::radii_becomeWidths()
{
    TreeDocument document;
    QVERIFY(sketchBranch(
        document, {.stroke = strokeOf({{0.0F, 0.0F}, {0.0F, 2.0F}}), .base = {}, .radii = {0.2F, 0.05F}}));
    QVERIFY(std::abs(document.tree().widthConstraint(tipOf(document, 0)) - 0.1F) < 1e-5F);
    QVERIFY(document.tree().widthConstraint(0) > 0.35F);
}

void SketchStrokeTest::replacedBranch_isGone()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    const InternodeId first = draw(document, {{0.0F, 1.0F}, {1.0F, 1.5F}});
    const BranchPlace base{document.tree().parent(first), document.tree().columns().along[first]};
    const Result<InternodeId> second =
        sketchBranch(document, {.stroke = strokeOf({{0.0F, 1.0F}, {1.0F, 1.4F}}),
                                .base = base,
                                .radii = {0.05F, 0.02F},
                                .replaces = first});
    QVERIFY(second);
    QVERIFY(!document.tree().isAlive(first));
    QVERIFY((placeOf(document, tipOf(document, *second)) - Vec3(1.0F, 1.4F, 0.0F)).norm() < 1e-5F);
    QCOMPARE(document.undoStack().count(), 3);
}

void SketchStrokeTest::replacedTrunk_standsOnItsOwnFoot()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    const Result<InternodeId> trunk = sketchBranch(
        document,
        {.stroke = strokeOf({{0.2F, 0.0F}, {0.2F, 2.2F}}), .base = {}, .radii = {0.2F}, .replaces = 0U});
    QVERIFY(trunk);
    QCOMPARE(*trunk, 0U);
    QVERIFY((document.tree().rootPosition(0) - Vec3(0.2F, 0.0F, 0.0F)).norm() < 1e-6F);
    QVERIFY((placeOf(document, tipOf(document, 0)) - Vec3(0.2F, 2.2F, 0.0F)).norm() < 1e-5F);
    document.undo();
    QVERIFY((placeOf(document, tipOf(document, 0)) - Vec3(0.0F, 2.0F, 0.0F)).norm() < 1e-5F);
}

void SketchStrokeTest::mirrorImage_growsOnTheOtherSide()
{
    TreeDocument document;
    draw(document, {{0.3F, 0.0F}, {0.3F, 2.0F}});
    BranchStroke stroke{.stroke = strokeOf({{0.3F, 1.0F}, {1.0F, 1.5F}}), .base = {}};
    stroke.isMirrored = true;
    const Result<InternodeId> first = sketchBranch(document, stroke);
    QVERIFY(first);
    InternodeId last = document.tree().size() - 1;
    QVERIFY((placeOf(document, last) - Vec3(-0.4F, 1.5F, 0.0F)).norm() < 1e-5F);
    QVERIFY((placeOf(document, tipOf(document, *first)) - Vec3(1.0F, 1.5F, 0.0F)).norm() < 1e-5F);
    QCOMPARE(document.undoStack().count(), 2);
}

void SketchStrokeTest::replacedMirrorImage_isGone()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    draw(document, {{0.0F, 0.5F}, {0.4F, 0.7F}});
    BranchStroke stroke{.stroke = strokeOf({{0.0F, 1.0F}, {1.0F, 1.5F}}), .base = {}};
    stroke.isMirrored = true;
    const Result<InternodeId> first = sketchBranch(document, stroke);
    QVERIFY(first);
    const InternodeId image = document.index().axis(document.tree().size() - 1);
    stroke.stroke = strokeOf({{0.0F, 1.0F}, {1.0F, 1.4F}});
    stroke.replaces = *first;
    QVERIFY(sketchBranch(document, stroke));
    QVERIFY(!document.tree().isAlive(*first) && !document.tree().isAlive(image));
    int axes = 0;
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        axes += document.tree().isAlive(id) && document.index().axis(id) == id ? 1 : 0;
    QCOMPARE(axes, 4);
    // Without an image, the branch that was drawn before it stays.
    const InternodeId other = draw(document, {{0.0F, 1.6F}, {0.5F, 1.9F}});
    const InternodeId last = draw(document, {{0.0F, 1.7F}, {0.5F, 2.0F}});
    stroke.stroke = strokeOf({{0.0F, 1.65F}, {0.5F, 2.0F}});
    stroke.replaces = last;
    QVERIFY(sketchBranch(document, stroke));
    QVERIFY(document.tree().isAlive(other) && !document.tree().isAlive(last));
}

void SketchStrokeTest::strokesWithoutLength_areRefused()
{
    TreeDocument document;
    const DocumentState before(document);
    QCOMPARE(draw(document, {{0.0F, 0.0F}, {0.0F, 0.0F}}), kNoInternode);
    QCOMPARE(draw(document, {{0.0F, 0.0F}, {0.0F, 2e4F}}), kNoInternode);
    QCOMPARE(differenceFrom(before, document), QString());
}

void SketchStrokeTest::depth_keepsTheFrontView()
{
    TreeDocument document;
    drawTree(document);
    const std::uint32_t size = document.tree().size();
    std::vector<Vec3> before;
    for (InternodeId id = 0; id < size; ++id)
        before.push_back(placeOf(document, id));
    const DocumentState flat(document);
    QVERIFY(inferDepth(document, {}));
    QVERIFY(!isFlat(document.tree(), document.index()));
    float deepest = 0.0F;
    for (InternodeId id = 0; id < size; ++id) {
        const Vec3& after = placeOf(document, id);
        QVERIFY((after - before[id]).head<2>().norm() < 1e-5F);
        deepest = std::max(deepest, std::abs(after.z()));
    }
    QVERIFY(deepest > 0.4F);
    document.undo();
    QCOMPARE(differenceFrom(flat, document), QString());
}

void SketchStrokeTest::depth_givesASecondTree()
{
    TreeDocument document;
    drawTree(document);
    const auto branches = [&] {
        std::size_t count = 0;
        for (InternodeId id = 0; id < document.tree().size(); ++id)
            count += document.tree().isAlive(id) && document.index().axis(id) == id ? 1 : 0;
        return count;
    };
    const std::size_t drawn = branches();
    QCOMPARE(drawn, 17U);
    QVERIFY(inferDepth(document, {}));
    QCOMPARE(branches(), 2 * (drawn - 1) + 1);
    // Every base lies on its parent, and side and front are about as wide.
    Box3 box;
    for (InternodeId id = 0; id < document.tree().size(); ++id)
        box.extend(placeOf(document, id));
    QVERIFY(box.sizes().z() > 0.7F * box.sizes().x() && box.sizes().z() < 1.4F * box.sizes().x());
    document.undo();
    QVERIFY(inferDepth(document, {.secondTree = false}));
    QCOMPARE(branches(), drawn);
}

void SketchStrokeTest::depth_givesTheSecondTreeItsLeaves()
{
    TreeDocument document;
    drawTree(document);
    const InternodeId bearer = document.tree().size() - 1; // On a branch of second order
    QVERIFY(placeLeaf(document, leafAt(bearer)));
    QVERIFY(placeLeaf(document, leafAt(0)));
    const DocumentState flat(document);
    QVERIFY(inferDepth(document, {}));
    const LeafColumns& leaves = document.tree().placedLeaves();
    // The trunk has no copy.
    QCOMPARE(leaves.size(), 3U);
    QVERIFY(leaves.internode[2] > bearer);
    QVERIFY(leaves.rotation[2].isApprox(leaves.rotation[0]));
    document.undo();
    QCOMPARE(differenceFrom(flat, document), QString());
}

void SketchStrokeTest::depth_isRefusedWhereThereIsSome()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    const Result<void> alone = inferDepth(document, {});
    QVERIFY(!alone);
    QCOMPARE(alone.error().message,
             QStringLiteral("draw branches first: a trunk alone has no depth to find"));
    draw(document, {{0.0F, 1.0F}, {1.0F, 1.5F}});
    draw(document, {{0.0F, 1.4F}, {-1.0F, 1.9F}});
    QVERIFY(inferDepth(document, {}));
    const Result<void> again = inferDepth(document, {});
    QVERIFY(!again);
    QCOMPARE(again.error().message, QStringLiteral("the tree has depth already"));
}

void SketchStrokeTest::depthTrial_replacesTheLastOne()
{
    TreeDocument document;
    drawTree(document);
    const int steps = document.undoStack().count();
    DepthTrial trial(document);
    QVERIFY(!trial.isLast());
    QVERIFY(trial.tryOut({.seed = 1}));
    const DocumentState first(document);
    QVERIFY(trial.tryOut({.seed = 2}));
    QVERIFY(differenceFrom(first, document) != QString());
    QCOMPARE(document.undoStack().count(), steps + 1);
    QVERIFY(trial.tryOut({.seed = 1}));
    QCOMPARE(differenceFrom(first, document), QString());
    // What is done after it ends the trial.
    const InternodeId tip = tipOf(document, 0);
    pruneBranches(document, std::span(&tip, 1));
    QVERIFY(!trial.isLast());
    QVERIFY(!trial.tryOut({.seed = 3}));
    QCOMPARE(document.undoStack().count(), steps + 2);
}

void SketchStrokeTest::trunkDrawnAgain_canBeSaved()
{
    TreeDocument document;
    const std::vector<Vec2> line{{0.0F, 0.0F}, {0.0F, 1.0F}};
    QVERIFY(sketchBranch(document, {.stroke = strokeOf(line), .base = {}, .radii = {0.1F, 0.05F}}));
    QVERIFY(sketchBranch(document, {.stroke = strokeOf({{0.0F, 0.0F}, {0.0F, 1.5F}}),
                                    .base = {},
                                    .radii = {0.1F, 0.05F},
                                    .replaces = InternodeId{0}}));
    QCOMPARE(fileFault(document), QString());
}

void SketchStrokeTest::depthOfCopiedTwigs_canBeSaved()
{
    TreeDocument document;
    draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
    const InternodeId limb = draw(document, {{0.0F, 0.8F}, {0.8F, 1.2F}});
    draw(document, {{0.0F, 1.4F}, {-0.8F, 1.8F}});
    // Two twigs at one node, of which the copies are born in the same step.
    const InternodeId node = document.index().mainChild(limb);
    QVERIFY(node != kNoInternode);
    for (const float up : {0.3F, -0.3F}) {
        const Vec3 base = placeOf(document, node);
        QVERIFY(sketchBranch(document,
                             {.stroke = strokeOf({{base.x(), base.y()}, {base.x() + 0.2F, base.y() + up}}),
                              .base = BranchPlace{node, 1.0F}}));
    }
    QVERIFY(propagateBranch(document, {.reference = limb, .axes = {}}));
    QVERIFY(inferDepth(document, {}));
    QCOMPARE(fileFault(document), QString());
}

void SketchStrokeTest::depthBeyondTheLimits_isRefused()
{
    TreeDocument document;
    QVERIFY(sketchBranch(document, {.stroke = strokeOf({{0.0F, 0.0F}, {0.0F, 990.0F}}), .base = {}}));
    for (const float side : {1.0F, -1.0F})
        QVERIFY(sketchBranch(document,
                             {.stroke = strokeOf({{0.0F, 400.0F}, {700.0F * side, 900.0F}}), .base = {}}));
    const Result<void> given = inferDepth(document, {.hullMagnification = 3.0});
    QVERIFY(given || given.error().message.startsWith(QLatin1String("an internode would be longer")));
    QCOMPARE(fileFault(document), QString());
}

void SketchStrokeTest::drawnTree_growsOn()
{
    TreeDocument document;
    drawTree(document);
    QVERIFY(inferDepth(document, {}));
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const bool isTip = document.index().mainChild(id) == kNoInternode;
        QCOMPARE((document.tree().buds(id) & kTerminalBud) != 0, isTip);
    }
}

void SketchStrokeTest::growth_keepsWhatWasDrawn()
{
    // A limb with twigs so dense that growth would shed most of them, passed on to five more limbs.
    for (const GrowthModelKind model : {GrowthModelKind::TreeSketch, GrowthModelKind::Vigour}) {
        TreeDocument document;
        TreeParameters parameters = document.parameters();
        parameters.growth.model = model;
        parameters.growth.shedding = 0.3;
        parameters.vigour.lightPruning = 0.9;
        document.reset(3, parameters);
        draw(document, {{0.0F, 0.0F}, {0.0F, 2.0F}});
        const InternodeId limb = draw(document, {{0.0F, 0.4F}, {1.0F, 0.9F}});
        for (int i = 0; i < 12; ++i) {
            const float x = 0.3F + 0.05F * static_cast<float>(i);
            draw(document, {{x, 0.4F + 0.5F * x}, {x + 0.02F, 0.55F + 0.5F * x}});
        }
        for (int i = 0; i < 5; ++i) {
            const float y = 0.5F + 0.1F * static_cast<float>(i);
            draw(document, {{0.0F, y}, {i % 2 == 0 ? -1.0F : 1.0F, y + 0.5F}});
        }
        Propagation twigs;
        twigs.reference = limb;
        QVERIFY(propagateBranch(document, twigs));
        QVERIFY(inferDepth(document, {}));
        const InternodeId drawn = document.tree().size();
        grow(document, 6);
        for (InternodeId id = 0; id < drawn; ++id)
            QVERIFY2(document.tree().isAlive(id), qPrintable(QString::number(id)));
        QVERIFY(document.tree().size() > drawn);
    }
}

static const TestClass<SketchStrokeTest> sketchStrokeTest;

} // namespace espalier::test

#include "SketchStrokeTest.moc"

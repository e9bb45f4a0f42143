// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BendGesture.h"
#include "commands/LassoGesture.h"
#include "commands/Prune.h"
#include "commands/WidthGesture.h"
#include "commands/recipe/PruneOperation.h"
#include "model/growth/GrowthStep.h"
#include "model/io/export/ExportScene.h"
#include "model/io/project/ProjectFile.h"
#include "model/mesh/LeafPlacer.h"
#include "model/mesh/TreeCounts.h"
#include "model/mesh/Tubes.h"
#include "model/mesh/WoodTracker.h"
#include "model/shape/BranchBend.h"
#include "model/shape/Pruning.h"
#include "model/shape/WidthRegions.h"
#include "tests/support/BruteForce.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/MeshTopology.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <array>
#include <map>
#include <set>

namespace espalier::test {

/// The algorithms and the commands on documents with several roots, of which one may be dead.
class SeveralRootsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase_data();

    void keys_ofRootsDiffer();
    void indices_knowEachInternodesRoot();
    void widths_growFromTipsByOnePower();
    void bareTrunks_taperByTheirOwnLengths();
    void widthConstraint_changesItsOwnTrunkAlone();
    void widthConstraintOnARoot_isItsDiameter();
    void cut_isAboveTheRoot_ofEachInternode();
    void prune_takesTheBranchAndLeavesAllRoots();
    void bend_movesItsOwnTrunkAlone();
    void growth_reachesEachTrunk();
    void selectiveGrowth_staysOnTheTrunkOfItsBud();
    void planarGrowth_knowsItsPlaceOnEachTrunk();
    void brush_growsTheTrunkBesideIt();
    void distantBrush_leadsTheNearestSeedling();
    void lasso_isFilledFromTheNearestSeedling();
    void picking_findsAllNodes();
    void mesh_isClosedAndFollowsGrowth();
    void leavesAndCounts_areThoseOfAllTrunks();
    void exportScene_hasTheBonesOfAllTrunks();
    void project_isSavedAndReadBack();
    void undo_leadsBackToTheSeedlings();
};

namespace {

constexpr double kTip = 0.004; ///< m
constexpr double kBase = 0.12; ///< m
constexpr float kApart = 6.0F; ///< m; crowns do not touch

Vec3 placeOfRoot(int root)
{
    return {kApart * static_cast<float>(root), 0.0F, -0.4F * static_cast<float>(root)};
}

/// Seedlings side by side, without history apart from their births.
void plant(TreeDocument& document)
{
    QFETCH_GLOBAL(int, roots);
    TreeParameters parameters;
    parameters.widths.tipDiameter = kTip;
    parameters.widths.baseDiameter = kBase;
    parameters.growth.internodeLength = 0.1;
    document.reset(5, parameters);
    for (int root = 1; root < roots; ++root)
        apply(document, rootBirth(document.tree(), document.index(), placeOfRoot(root)));
}

/// Lets the second root die, if the data say so.
void killSecond(TreeDocument& document)
{
    QFETCH_GLOBAL(bool, secondDies);
    if (secondDies)
        apply(document, death(document.tree(), document.index(), document.index().roots()[1]));
}

/// Branched trees side by side.
struct Grove {
    Grove()
    {
        plant(document);
        grow(document, 7);
        killSecond(document);
    }

    const Tree& tree() const { return document.tree(); }
    const TreeIndex& index() const { return document.index(); }
    /// The living root that was planted last.
    InternodeId last() const { return index().roots().back(); }
    /// The internode of the trunk of @p root that is farthest from it.
    InternodeId tipOf(InternodeId root) const { return trunkTip(index(), root); }

    TreeDocument document;
};

InternodeId rootByParents(const Tree& tree, InternodeId id)
{
    while (tree.parent(id) != kNoInternode)
        id = tree.parent(id);
    return id;
}

float relativeDifference(float a, float b)
{
    return std::abs(a - b) / std::max({a, b, 1e-9F});
}

/// A root of which @p document has an internode that @p before does not have; kNoInternode if there is none
/// or more than one.
InternodeId onlyGrownRoot(const TreeDocument& document, std::uint32_t before)
{
    std::set<InternodeId> grown;
    for (InternodeId id = before; id < document.tree().size(); ++id)
        grown.insert(rootByParents(document.tree(), id));
    return grown.size() == 1 ? *grown.begin() : kNoInternode;
}

} // namespace

void SeveralRootsTest::initTestCase_data()
{
    QTest::addColumn<int>("roots");
    QTest::addColumn<bool>("secondDies");
    QTest::newRow("two") << 2 << false;
    QTest::newRow("three") << 3 << false;
    QTest::newRow("three, one of them dead") << 3 << true;
}

void SeveralRootsTest::keys_ofRootsDiffer()
{
    const Grove grove;
    std::set<InternodeKey> keys;
    for (const InternodeId root : grove.index().roots())
        keys.insert(grove.tree().key(root));
    QCOMPARE(keys.size(), grove.index().roots().size());
    QCOMPARE(treeFault(grove.tree().content()), QString());
    QCOMPARE(rootKey(7, 0), rootKey(7));
    QCOMPARE(Tree(7).key(0), rootKey(7));
}

void SeveralRootsTest::indices_knowEachInternodesRoot()
{
    const Grove grove;
    QCOMPARE(indexFault(grove.document), QString());
    for (InternodeId id = 0; id < grove.tree().size(); ++id)
        QCOMPARE(grove.index().rootOf(grove.tree(), id), rootByParents(grove.tree(), id));
    for (const InternodeId root : grove.index().roots()) {
        QVERIFY(!grove.tree().isAlive(root) || grove.index().tipCount(root) > 2);
        QCOMPARE(rootByParents(grove.tree(), grove.tipOf(root)), root);
    }
}

void SeveralRootsTest::widths_growFromTipsByOnePower()
{
    const Grove grove;
    const TreeIndex& index = grove.index();
    const Widths widths(grove.tree(), index);
    QVERIFY(widths.dependOnTipsAlone());
    float thickest = 0.0F;
    for (const InternodeId root : index.roots())
        thickest = std::max(thickest, widths.radius(index, root));
    QVERIFY(relativeDifference(thickest, 0.5F * static_cast<float>(kBase)) < 1e-5F);
    for (InternodeId id = 0; id < grove.tree().size(); ++id) {
        const double tips = index.tipCount(id);
        const double expected = tips > 0 ? 0.5 * kTip * std::pow(tips, widths.power()) : 0.0;
        QVERIFY(relativeDifference(widths.radius(index, id), static_cast<float>(expected)) < 1e-5F);
    }
    // The radii that are computed region by region are the same.
    const std::vector<float> radii = constrainedRadii(grove.tree(), index, {}, widths.power());
    for (InternodeId id = 0; id < grove.tree().size(); ++id)
        QVERIFY(relativeDifference(radii[id], widths.radius(index, id)) < 1e-4F);
}

void SeveralRootsTest::bareTrunks_taperByTheirOwnLengths()
{
    TreeDocument document;
    plant(document);
    GrowthWorkspace workspace;
    // Each trunk is longer than the one before it.
    for (const InternodeId root :
         std::vector(document.index().roots().begin(), document.index().roots().end())) {
        const BudRef bud{root, kTerminalSlot};
        const Vec3 target = document.index().nodePosition(root) + Vec3(0.0F, 9.0F, 0.0F);
        const int count = 1 + static_cast<int>(root);
        apply(document, growLeader(document.tree(), document.index(), bud, target, 0.1F, count, workspace));
    }
    killSecond(document);
    const TreeIndex& index = document.index();
    const Widths widths(document.tree(), index);
    for (const InternodeId root : index.roots()) {
        float length = 0.0F;
        for (InternodeId id = root; id != kNoInternode; id = index.firstChild(id))
            length += document.tree().length(id);
        const float expected =
            document.tree().isAlive(root) ? 0.5F * std::min(static_cast<float>(kBase), length / 3.0F) : 0.0F;
        QVERIFY(relativeDifference(widths.radius(index, root), expected) < 1e-4F);
        if (document.tree().isAlive(root))
            QVERIFY(relativeDifference(widths.radius(index, trunkTip(index, root)),
                                       0.5F * static_cast<float>(kTip)) < 1e-4F);
    }
}

void SeveralRootsTest::widthConstraint_changesItsOwnTrunkAlone()
{
    Grove grove;
    const TreeIndex& index = grove.index();
    const Widths before(grove.tree(), index);
    InternodeId above = grove.last();
    for (int i = 0; i < 3; ++i)
        above = index.mainChild(above);
    setWidth(grove.document, above, 0.031);
    const Widths after(grove.tree(), index);
    QVERIFY(!after.dependOnTipsAlone());
    QVERIFY(relativeDifference(after.radius(index, above), 0.0155F) < 1e-5F);
    bool hasChanged = false;
    for (InternodeId id = 0; id < grove.tree().size(); ++id) {
        const float difference = relativeDifference(before.radius(index, id), after.radius(index, id));
        if (rootByParents(grove.tree(), id) != grove.last())
            QVERIFY(difference < 1e-4F);
        else
            hasChanged = hasChanged || difference > 0.05F;
    }
    QVERIFY(hasChanged);
    QVERIFY(relativeDifference(before.radius(index, grove.last()), after.radius(index, grove.last())) <
            1e-4F);
    grove.document.undo();
    QCOMPARE(indexFault(grove.document), QString());
}

void SeveralRootsTest::widthConstraintOnARoot_isItsDiameter()
{
    Grove grove;
    const TreeIndex& index = grove.index();
    const Widths before(grove.tree(), index);
    setWidth(grove.document, grove.last(), 0.2);
    const Widths after(grove.tree(), index);
    QVERIFY(relativeDifference(after.radius(index, grove.last()), 0.1F) < 1e-5F);
    for (const InternodeId root : index.roots()) {
        if (root != grove.last())
            QVERIFY(relativeDifference(before.radius(index, root), after.radius(index, root)) < 1e-4F);
    }
}

void SeveralRootsTest::cut_isAboveTheRoot_ofEachInternode()
{
    const Grove grove;
    const Tree& tree = grove.tree();
    for (InternodeId id = 0; id < tree.size(); ++id) {
        const InternodeId cut = cutBelow(tree, grove.index(), id);
        if (!tree.isAlive(id) || tree.isRoot(id)) {
            QCOMPARE(cut, kNoInternode);
            continue;
        }
        QVERIFY(!tree.isRoot(cut) && !pathBetween(tree, cut, id).empty());
        const InternodeId parent = tree.parent(cut);
        QVERIFY(tree.isRoot(parent) ||
                grove.index().nextSibling(grove.index().firstChild(parent)) != kNoInternode);
    }
}

void SeveralRootsTest::prune_takesTheBranchAndLeavesAllRoots()
{
    Grove grove;
    const Tree& tree = grove.tree();
    const std::uint32_t size = tree.size();
    // The first internodes are the roots.
    for (InternodeId id = 0; id < size; id += id < 10 ? 1 : size / 12) {
        const DocumentState before(grove.document);
        const InternodeId cut = cutBelow(tree, grove.index(), id);
        const std::vector<InternodeId> expected =
            cut == kNoInternode ? std::vector<InternodeId>() : bruteSubtree(tree, cut);
        pruneBranches(grove.document, std::array{cut});
        for (InternodeId other = 0; other < size; ++other) {
            const bool falls = std::ranges::binary_search(expected, other);
            QCOMPARE(tree.isAlive(other), before.tree.isAlive(other) && !falls);
        }
        if (expected.empty())
            continue;
        QCOMPARE(indexFault(grove.document), QString());
        grove.document.undo();
        QCOMPARE(differenceFrom(before, grove.document), QString());
    }
    for (const InternodeId root : grove.index().roots()) {
        if (!tree.isAlive(root))
            continue;
        const DocumentState before(grove.document);
        const PruneOperation operation{{InternodeReference::to(grove.document, root)}};
        QCOMPARE(operation.perform(grove.document),
                 QStringLiteral("internode %1 is a root, which cannot be pruned").arg(root));
        QCOMPARE(differenceFrom(before, grove.document), QString());
    }
}

void SeveralRootsTest::bend_movesItsOwnTrunkAlone()
{
    Grove grove;
    const InternodeId root = grove.last();
    const InternodeId tip = grove.tipOf(root);
    const DocumentState before(grove.document);
    const TreeIndex indexBefore = grove.index();
    const Vec3 target = grove.index().nodePosition(tip) + Vec3(0.2F, -0.1F, 0.1F);
    BendGesture gesture(grove.document, root, {{tip}});
    gesture.settleAt(std::span(&target, 1));
    gesture.finish();
    QVERIFY((grove.index().nodePosition(tip) - target).norm() < 0.02F);
    QCOMPARE(grove.index().nodePosition(root), indexBefore.nodePosition(root));
    for (InternodeId id = 0; id < grove.tree().size(); ++id) {
        if (rootByParents(grove.tree(), id) != root)
            QCOMPARE(grove.index().nodePosition(id), indexBefore.nodePosition(id));
    }
    QCOMPARE(indexFault(grove.document), QString());
    grove.document.undo();
    QCOMPARE(differenceFrom(before, grove.document), QString());
    // A path between two trunks does not exist.
    QVERIFY(pathBetween(grove.tree(), 0, tip).empty());
}

void SeveralRootsTest::growth_reachesEachTrunk()
{
    Grove grove;
    const DocumentState before(grove.document);
    std::map<InternodeId, std::uint32_t> sizes;
    for (const InternodeId root : grove.index().roots())
        sizes[root] = grove.index().subtreeSize(root);
    QCOMPARE(grow(grove.document, 4), 4);
    for (const InternodeId root : grove.index().roots())
        QCOMPARE(grove.index().subtreeSize(root) > sizes[root], grove.tree().isAlive(root));
    QCOMPARE(indexFault(grove.document), QString());
    QCOMPARE(treeFault(grove.tree().content()), QString());
    grove.document.undo();
    QCOMPARE(differenceFrom(before, grove.document), QString());
}

void SeveralRootsTest::selectiveGrowth_staysOnTheTrunkOfItsBud()
{
    TreeDocument document;
    plant(document);
    const std::uint32_t before = document.tree().size();
    QCOMPARE(grow(document, 4, {0, kTerminalSlot}), 4);
    QCOMPARE(onlyGrownRoot(document, before), 0U);
    const InternodeId last = document.index().roots().back();
    document.undo();
    QCOMPARE(grow(document, 4, {last, kTerminalSlot}), 4);
    QCOMPARE(onlyGrownRoot(document, before), last);
}

void SeveralRootsTest::planarGrowth_knowsItsPlaceOnEachTrunk()
{
    TreeDocument document;
    plant(document);
    killSecond(document);
    GrowthStepOptions options = GrowthStepOptions::of(document.parameters().growth);
    options.isPlanar = true;
    GrowthWorkspace workspace;
    for (int step = 0; step < 6; ++step)
        apply(document,
              document.growthModel().growFreely(document.tree(), document.index(), options, workspace));
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const Vec3 root = document.index().basePosition(document.tree(), rootByParents(document.tree(), id));
        QVERIFY(std::abs(document.index().nodePosition(id).z() - root.z()) < 1e-4F);
    }
    const std::span<const InternodeId> roots = document.index().roots();
    QVERIFY(document.index().subtreeSize(roots.back()) > 6);
}

void SeveralRootsTest::brush_growsTheTrunkBesideIt()
{
    Grove grove;
    const DocumentState before(grove.document);
    const Vec3 tip = grove.index().nodePosition(grove.tipOf(grove.last()));
    const std::vector<Vec3> path{tip, tip + Vec3(0.3F, 1.0F, 0.0F)};
    brush(grove.document, strokeAlong(path, 0.4F, 1.5));
    QVERIFY(grove.tree().size() > before.tree.size());
    QCOMPARE(onlyGrownRoot(grove.document, before.tree.size()), grove.last());
    QCOMPARE(indexFault(grove.document), QString());
    grove.document.undo();
    QCOMPARE(differenceFrom(before, grove.document), QString());
}

void SeveralRootsTest::distantBrush_leadsTheNearestSeedling()
{
    TreeDocument document;
    plant(document);
    killSecond(document);
    const DocumentState before(document);
    const InternodeId last = document.index().roots().back();
    const Vec3 far = document.index().nodePosition(last) + Vec3(0.5F, 4.0F, 0.0F);
    brush(document, strokeAlong(std::vector{far, Vec3(far + Vec3(0.0F, 0.1F, 0.0F))}, 0.2F, 0.3));
    QVERIFY(document.tree().size() > before.tree.size() + 3);
    QCOMPARE(onlyGrownRoot(document, before.tree.size()), last);
    QCOMPARE(document.index().tipCount(last), 1U);
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());

    // Beside branched trees, too.
    Grove grove;
    apply(grove.document, rootBirth(grove.tree(), grove.index(), placeOfRoot(4)));
    const std::uint32_t planted = grove.tree().size();
    const Vec3 above = placeOfRoot(4) + Vec3(0.0F, 2.0F, 0.0F);
    brush(grove.document, strokeAlong(std::vector{above, Vec3(above + Vec3(0.0F, 0.1F, 0.0F))}, 0.2F, 0.3));
    QVERIFY(grove.tree().size() > planted + 3);
    QCOMPARE(onlyGrownRoot(grove.document, planted), grove.last());
}

void SeveralRootsTest::lasso_isFilledFromTheNearestSeedling()
{
    TreeDocument document;
    plant(document);
    killSecond(document);
    const DocumentState before(document);
    const InternodeId last = document.index().roots().back();
    const Vec3 base = document.index().basePosition(document.tree(), last);
    LassoStroke stroke;
    stroke.origin = base + Vec3(0.0F, 2.0F, 0.0F);
    stroke.points = {{-0.5F, 0.0F}, {0.5F, 0.0F}, {0.5F, 1.0F}, {-0.5F, 1.0F}};
    const LassoGesture::Begun begun = LassoGesture::fill(document, stroke);
    QVERIFY(begun);
    for (int step = 0; step < 12 && (*begun)->step(); ++step) {
    }
    (*begun)->finish();
    QVERIFY(document.tree().size() > before.tree.size() + 20);
    QCOMPARE(onlyGrownRoot(document, before.tree.size()), last);
    QCOMPARE(indexFault(document), QString());
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());
}

void SeveralRootsTest::picking_findsAllNodes()
{
    Grove grove;
    const auto found = [&] {
        std::set<InternodeId> ids;
        grove.document.pickIndex().forEachCell([&](const Vec3&, float, PickIndex::Nodes nodes) {
            for (const PickIndex::Node& node : nodes)
                ids.insert(node.id);
        });
        return ids;
    };
    const auto living = [&] {
        std::set<InternodeId> ids;
        for (InternodeId id = 0; id < grove.tree().size(); ++id) {
            if (grove.tree().isAlive(id))
                ids.insert(id);
        }
        return ids;
    };
    QVERIFY(found() == living());
    grow(grove.document, 2);
    QVERIFY(found() == living());
    while (grove.document.undoStack().canUndo())
        grove.document.undo();
    QVERIFY(found() == std::set<InternodeId>{0});
}

void SeveralRootsTest::mesh_isClosedAndFollowsGrowth()
{
    TreeDocument document;
    plant(document);
    WoodTracker tracker;
    tracker.restart(document.tree(), document.index());
    connect(&document, &TreeDocument::changed, this, [&](const TreeChange& change) {
        if (change.delta != nullptr)
            tracker.follow(document.tree(), document.index(), *change.delta);
    });
    const auto mesh = [&] {
        const Tree& tree = document.tree();
        const TreeIndex& index = document.index();
        const WoodTracker::Work work = tracker.take(tree, index, tree.size());
        const std::unique_ptr<WoodPieceMesher> piece = tracker.pieceMesher(tree, index);
        for (const InternodeId base : work.wood) {
            const MeshSize size = piece->prepare(base);
            std::vector<MeshVertex> vertices(size.vertices);
            std::vector<VertexIndex> indices(size.indices);
            piece->write(vertices, indices);
            QVERIFY(topologyOf(vertices, indices).isClosedManifold());
            QCOMPARE(piece->supportRadius() > 0.0F, !tree.isRoot(base));
            tracker.noteMeshed(*piece);
        }
        const Widths widths(tree, index);
        for (InternodeId id = 0; id < tree.size(); ++id) {
            QVERIFY(relativeDifference(tracker.meshedRadius(id), widths.radius(index, id)) <=
                    1.5F * WoodTracker::kTolerance);
        }
        QVERIFY(tubeWood().pieces(tree, index) == tubesOf(tree, index));
        for (const InternodeId root : index.roots())
            QCOMPARE(std::ranges::binary_search(tubesOf(tree, index), root), tree.isAlive(root));
    };
    mesh();
    for (int step = 0; step < 9; ++step) {
        grow(document, 1);
        mesh();
    }
    killSecond(document);
    mesh();
    while (document.undoStack().canUndo()) {
        document.undo();
        mesh();
    }
    disconnect(&document, nullptr, this, nullptr);
}

void SeveralRootsTest::leavesAndCounts_areThoseOfAllTrunks()
{
    const Grove grove;
    const LeafRule rule(grove.tree(), grove.index());
    std::size_t leaves = 0;
    std::uint64_t axes = 0;
    for (InternodeId id = 0; id < grove.tree().size(); ++id) {
        if (!grove.tree().isAlive(id))
            continue;
        leaves += rule.bears(id) ? rule.leavesPerInternode() : 0;
        axes += grove.index().axis(id) == id ? 1 : 0;
    }
    QVERIFY(leaves > 0);
    const auto placed = placeLeaves(grove.tree(), grove.index(), Widths(grove.tree(), grove.index()));
    QCOMPARE(placed.size(), leaves);
    const TreeCounts counts = countTree(grove.tree(), grove.index());
    QCOMPARE(counts.axes, axes);
    QCOMPARE(counts.leaves, leaves);
    const Box3 bounds = treeBounds(grove.tree(), grove.index());
    for (const InternodeId root : grove.index().roots()) {
        if (grove.tree().isAlive(root))
            QVERIFY(bounds.contains(grove.index().basePosition(grove.tree(), root)));
    }
}

void SeveralRootsTest::exportScene_hasTheBonesOfAllTrunks()
{
    const Grove grove;
    const ExportScene scene = buildExportScene(grove.tree(), grove.index(), QStringLiteral("grove"), {},
                                               {.surface = false, .skeleton = true});
    QCOMPARE(scene.skeleton.size(), std::size_t{grove.index().livingCount()});
    std::set<InternodeId> bases;
    for (const auto& bone : scene.skeleton) {
        if (bone.parent == kNoInternode)
            bases.insert(bone.id);
    }
    for (const InternodeId root : grove.index().roots())
        QCOMPARE(bases.contains(root), grove.tree().isAlive(root));
}

void SeveralRootsTest::project_isSavedAndReadBack()
{
    Grove grove;
    Project project;
    project.tree = grove.tree();
    project.journal = grove.document.journal();
    const Result<QByteArray> packed = packProject(project);
    QVERIFY2(packed, packed ? "" : qPrintable(packed.error().message));
    const Result<Project> read = unpackProject(*packed);
    QVERIFY2(read, read ? "" : qPrintable(read.error().message));
    QVERIFY(read->tree == project.tree);
    QVERIFY(std::ranges::equal(read->journal, project.journal,
                               [](const auto& a, const auto& b) { return *a == *b; }));
    TreeDocument opened;
    opened.reset(read->tree, read->journal);
    QCOMPARE(indexFault(opened), QString());
    grow(grove.document, 2);
    grow(opened, 2);
    QVERIFY(opened.tree() == grove.tree());
}

void SeveralRootsTest::undo_leadsBackToTheSeedlings()
{
    TreeDocument document;
    plant(document);
    const DocumentState seedlings(document);
    const int planted = document.undoStack().index();
    grow(document, 7);
    killSecond(document);
    const InternodeId last = document.index().roots().back();
    setWidth(document, document.index().mainChild(last), 0.05);
    pruneBranches(document,
                  std::array{cutBelow(document.tree(), document.index(), trunkTip(document.index(), last))});
    grow(document, 2);
    const DocumentState done(document);
    while (document.undoStack().index() > planted) {
        document.undo();
        QCOMPARE(indexFault(document), QString());
    }
    QVERIFY(document.tree() == seedlings.tree);
    while (document.undoStack().canRedo()) {
        document.redo();
        QCOMPARE(indexFault(document), QString());
    }
    QCOMPARE(differenceFrom(done, document), QString());
}

const TestClass<SeveralRootsTest> severalRootsTest;

} // namespace espalier::test

#include "SeveralRootsTest.moc"

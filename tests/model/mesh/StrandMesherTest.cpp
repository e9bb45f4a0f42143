// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandMesher.h"

#include "model/mesh/SurfaceCheck.h"
#include "model/shape/Pruning.h"
#include "model/shape/Twist.h"
#include "tests/support/MeshTopology.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

namespace espalier::test {

namespace {

BranchMesh strandMesh(const TreeBuilder& builder, const WoodMeshOptions& options = {})
{
    return meshStrands(StrandLayouts(builder.tree, builder.index, Widths(builder.tree, builder.index)),
                       builder.tree.parameters(), options);
}

void setWood(TreeBuilder& builder, const std::function<void(WoodParameters&)>& change)
{
    TreeParameters parameters = builder.tree.parameters();
    change(parameters.wood);
    builder.apply(parameterChange(builder.tree, parameters));
}

/// A polygon of random radii around @p centre; clockwise for cavities does not matter to a profile.
StrandProfile::Loop blob(Random& random, const Vec2& centre, double radius)
{
    StrandProfile::Loop loop;
    const int count = 5 + static_cast<int>(random.uniform(0.0, 20.0));
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        const double far = radius * random.uniform(0.5, 1.0);
        loop.push_back(centre + Vec2(static_cast<float>(far * std::cos(angle)),
                                     static_cast<float>(far * std::sin(angle))));
    }
    return loop;
}

/// One part, a part with a cavity, or two or three parts.
StrandProfile randomProfile(Random& random)
{
    StrandProfile profile;
    switch (static_cast<int>(random.uniform(0.0, 4.0))) {
    case 0:
        profile.boundaries.push_back(blob(random, Vec2::Zero(), 1.0));
        break;
    case 1:
        profile.boundaries.push_back(blob(random, Vec2::Zero(), 1.0));
        profile.boundaries.push_back(blob(random, Vec2::Zero(), 0.4));
        break;
    case 2:
        profile.boundaries.push_back(blob(random, Vec2(-1.5F, 0.0F), 1.2));
        profile.boundaries.push_back(blob(random, Vec2(1.5F, 0.0F), 1.2));
        break;
    default:
        profile.boundaries.push_back(blob(random, Vec2(-1.2F, 0.0F), 1.0));
        profile.boundaries.push_back(blob(random, Vec2(1.2F, 0.0F), 1.0));
        profile.boundaries.push_back(blob(random, Vec2(0.0F, 2.4F), 1.0));
    }
    return profile;
}

/// Gives random nodes profiles and twists.
void shapeAtRandom(TreeBuilder& builder, Random& random)
{
    TreeDelta delta = deltaStartingAt(builder.tree);
    for (InternodeId id = 0; id < builder.tree.size(); ++id) {
        if (!builder.tree.isAlive(id))
            continue;
        if (random.uniform() < 0.15)
            delta.sparse.profile.push_back(
                {id, std::nullopt, keepProfile(delta, builder.tree, randomProfile(random))});
        if (random.uniform() < 0.1)
            delta.sparse.twist.push_back(
                {id, std::nullopt, static_cast<float>(random.uniform(-kMostTwist, kMostTwist))});
    }
    builder.apply(std::move(delta));
}

std::shared_ptr<const StrandWood> woodOf(const Tree& tree, const StrandWood* last)
{
    WorkProgress progress;
    const TreeIndex index(tree);
    const StrandLayouts* const lastLayouts = last != nullptr ? last->layouts.get() : nullptr;
    return meshStrands(std::make_shared<const StrandLayouts>(tree, index, Widths(tree, index), lastLayouts),
                       tree.parameters(), {}, last, progress);
}

/// What differs between two meshes; empty if they are the same, byte for byte.
QString difference(const StrandWood& wood, const StrandWood& other)
{
    const StrandSkeleton& skeleton = wood.layouts->skeleton();
    for (std::uint32_t node = 0; node < skeleton.nodes.size(); ++node) {
        if (!std::ranges::equal(wood.layouts->places(node), other.layouts->places(node)))
            return QStringLiteral("places at node %1").arg(node);
    }
    const BranchMesh& a = *wood.mesh;
    const BranchMesh& b = *other.mesh;
    if (a.vertices.size() != b.vertices.size() || a.indices.size() != b.indices.size())
        return QStringLiteral("sizes: %1 and %2 vertices").arg(a.vertices.size()).arg(b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
        if (std::memcmp(&a.vertices[i], &b.vertices[i], sizeof(MeshVertex)) != 0)
            return QStringLiteral("vertex %1").arg(i);
    }
    if (!std::ranges::equal(a.indices, b.indices))
        return QStringLiteral("indices");
    return a.origins == b.origins ? QString() : QStringLiteral("origins");
}

InternodeId randomInternode(const Tree& tree, Random& random)
{
    for (;;) {
        const auto id = static_cast<InternodeId>(random.uniform(0.0, static_cast<double>(tree.size())));
        if (id < tree.size() && tree.isAlive(id))
            return id;
    }
}

/// An edit of one place, or seldom of the parameters of the wood.
void editAtRandom(TreeBuilder& builder, Random& random)
{
    const InternodeId id = randomInternode(builder.tree, random);
    TreeDelta delta = deltaStartingAt(builder.tree);
    switch (static_cast<int>(random.uniform(0.0, 8.0))) {
    case 0:
    case 1:
    case 2:
        delta.sparse.profile.push_back({id, builder.tree.content().sparse.profile.at(id),
                                        keepProfile(delta, builder.tree, randomProfile(random))});
        break;
    case 3:
        if (const auto profile = builder.tree.content().sparse.profile.at(id))
            delta.sparse.profile.push_back({id, profile, std::nullopt});
        break;
    case 4:
        delta.sparse.twist.push_back(
            {id, builder.tree.content().sparse.twist.at(id), static_cast<float>(random.uniform(-1.0, 1.0))});
        break;
    case 5:
        setWood(builder, [&](WoodParameters& wood) {
            switch (static_cast<int>(random.uniform(0.0, 5.0))) {
            case 0:
                wood.alpha = random.uniform(3.0, 100.0);
                break;
            case 1:
                wood.smoothing = random.uniform();
                break;
            case 2:
                wood.flutes = random.uniform();
                break;
            case 3:
                wood.strandsPerTip = 1 + static_cast<int>(random.uniform(0.0, 4.0));
                break;
            default:
                wood.strandRadius = random.uniform() < 0.5 ? 0.0 : random.uniform(0.001, 0.005);
            }
        });
        return;
    default:
        if (id != 0)
            delta = prune(builder.tree, builder.index, std::array{id});
    }
    if (!delta.isEmpty())
        builder.apply(std::move(delta));
}

void verifyClosed(const BranchMesh& mesh, std::uint64_t bases)
{
    const SurfaceFaults faults = checkSurface(mesh);
    QCOMPARE(faults.openEdges, 0U);
    QCOMPARE(faults.nonManifoldEdges, 0U);
    QCOMPARE(faults.nonManifoldVertices, 0U);
    QCOMPARE(faults.degenerate, 0U);
    QCOMPARE(faults.inverted, 0U);
    QVERIFY(faults.components >= bases);
}

} // namespace

/// The closed surface around strands; algorithms.md L.9.
class StrandMesherTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void seedling_isOneClosedSurface();
    void randomTrees_haveOneClosedSurface_data();
    void randomTrees_haveOneClosedSurface();
    void randomProfiles_leaveTheSurfaceClosed_data();
    void randomProfiles_leaveTheSurfaceClosed();
    void lostLimbs_leaveTheSurfaceClosed();
    void volume_isThatOfTheStrands();
    void mesh_isTheSameOnOneThreadAndMany();
    void takenParts_areAsThoseMadeAnew_data();
    void takenParts_areAsThoseMadeAnew();
    void smallEdit_leavesMostOfTheMesh_data();
    void smallEdit_leavesMostOfTheMesh();
    void cancelledMesh_isNone();
    void textureCoordinates_areContinuousAcrossEdges();
    void coarserMeshes_haveFewerTrianglesAndAreClosed_data();
    void coarserMeshes_haveFewerTrianglesAndAreClosed();
    void greaterAlpha_needsFewerInnerWalls();
    void severalRoots_areSurfacesEach();
};

void StrandMesherTest::seedling_isOneClosedSurface()
{
    const TreeBuilder seedling;
    const BranchMesh mesh = strandMesh(seedling);
    verifyClosed(mesh, 1);
    QCOMPARE(checkSurface(mesh).components, 1U);
}

void StrandMesherTest::randomTrees_haveOneClosedSurface_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<int>("perTip");
    for (int seed = 0; seed < 60; ++seed)
        QTest::addRow("%d", seed) << seed << 1 + seed % 5;
}

void StrandMesherTest::randomTrees_haveOneClosedSurface()
{
    QFETCH(int, seed);
    QFETCH(int, perTip);
    TreeBuilder builder =
        raisedTree(30U + 17U * static_cast<std::uint32_t>(seed), static_cast<std::uint64_t>(seed) + 1);
    setWood(builder, [&](WoodParameters& wood) { wood.strandsPerTip = perTip; });
    const BranchMesh mesh = strandMesh(builder);
    verifyClosed(mesh, 1);
    QCOMPARE(checkSurface(mesh).components, 1U);
}

void StrandMesherTest::randomProfiles_leaveTheSurfaceClosed_data()
{
    QTest::addColumn<int>("seed");
    // ESPALIER_FIRST_SEED tries others.
    const int first = qEnvironmentVariableIntValue("ESPALIER_FIRST_SEED");
    for (int seed = first; seed < first + 200; ++seed)
        QTest::addRow("%d", seed) << seed;
    // A cavity that ends beside a fork; outlines that touch in one strand, with joined edges on both sides of
    // it; two cavities with a strand in common.
    for (const int seed : {798, 1178, 2882})
        QTest::addRow("%d again", seed) << seed;
}

void StrandMesherTest::randomProfiles_leaveTheSurfaceClosed()
{
    QFETCH(int, seed);
    Random random(static_cast<std::uint64_t>(seed), 0, 0, Purpose::Leaf);
    TreeBuilder builder =
        raisedTree(20U + 3U * static_cast<std::uint32_t>(seed % 200), static_cast<std::uint64_t>(seed) + 1);
    setWood(builder, [&](WoodParameters& wood) {
        wood.strandsPerTip = 1 + static_cast<int>(random.uniform(0.0, 5.0));
        wood.alpha = random.uniform(3.0, 12.0);
        wood.steps = random.uniform() < 0.5 ? 500 : static_cast<int>(random.uniform(0.0, 100.0));
        wood.packing = random.uniform() < 0.8 ? StrandPacking::Rest : StrandPacking::Pbd;
        wood.smoothing = random.uniform();
    });
    shapeAtRandom(builder, random);
    verifyClosed(strandMesh(builder), 1);
}

void StrandMesherTest::lostLimbs_leaveTheSurfaceClosed()
{
    int hollows = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        Random random(seed, 0, 0, Purpose::Leaf);
        TreeBuilder builder = raisedTree(600, seed);
        setWood(builder, [&](WoodParameters& wood) {
            wood.strandsPerTip = 5;
            wood.flutes = random.uniform(0.2, 1.0);
            wood.alpha = random.uniform(2.0, 60.0);
            wood.steps = random.uniform() < 0.7 ? 500 : static_cast<int>(random.uniform(0.0, 60.0));
        });
        // Limbs of some dozens of internodes.
        for (InternodeId id = 0; id < builder.tree.size(); ++id) {
            if (builder.tree.isAlive(id) && !builder.tree.continuesAxis(id) && id > 0 &&
                random.uniform() < 0.2)
                builder.apply(prune(builder.tree, builder.index, std::array{id}));
        }
        if (random.uniform() < 0.5)
            shapeAtRandom(builder, random);
        const StrandLayouts layouts(builder.tree, builder.index, Widths(builder.tree, builder.index));
        for (std::uint32_t node = 0; node < layouts.skeleton().nodes.size(); ++node)
            hollows += layouts.reliefs().hasHollow(node) ? 1 : 0;
        verifyClosed(meshStrands(layouts, builder.tree.parameters()), 1);
    }
    QVERIFY2(hollows > 30, qPrintable(QString::number(hollows)));
}

void StrandMesherTest::volume_isThatOfTheStrands()
{
    TreeBuilder builder = raisedTree(1500, 3);
    constexpr double radius = 0.004;
    setWood(builder, [&](WoodParameters& wood) {
        wood.strandRadius = radius;
        wood.strandsPerTip = 5;
    });
    const StrandLayouts layouts(builder.tree, builder.index, Widths(builder.tree, builder.index));
    double strands = 0.0;
    for (const StrandNode& node : layouts.skeleton().nodes) {
        const StrandNode& below = layouts.skeleton().nodes[node.parent];
        strands += node.strands * std::numbers::pi * radius * radius *
                   double{(node.position - below.position).norm()};
    }
    const double volume = enclosedVolume(meshStrands(layouts, builder.tree.parameters()));
    QVERIFY2(volume > strands && volume < 1.6 / 0.75 * strands,
             qPrintable(QString::number(volume / strands)));
}

void StrandMesherTest::mesh_isTheSameOnOneThreadAndMany()
{
    TreeBuilder builder = raisedTree(2500, 2);
    Random random(7, 0, 0, Purpose::Leaf);
    shapeAtRandom(builder, random);
    const BranchMesh many = strandMesh(builder);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const BranchMesh single = strandMesh(builder);
    QVERIFY(std::ranges::equal(many.vertices, single.vertices));
    QVERIFY(std::ranges::equal(many.indices, single.indices));
    QVERIFY(many.origins == single.origins);
}

void StrandMesherTest::takenParts_areAsThoseMadeAnew_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 30; ++seed)
        QTest::addRow("%d", seed) << seed;
}

void StrandMesherTest::takenParts_areAsThoseMadeAnew()
{
    QFETCH(int, seed);
    Random random(static_cast<std::uint64_t>(seed), 0, 0, Purpose::Leaf);
    TreeBuilder builder =
        raisedTree(60U + 30U * static_cast<std::uint32_t>(seed), static_cast<std::uint64_t>(seed) + 1);
    setWood(builder, [&](WoodParameters& wood) {
        wood.strandsPerTip = 1 + static_cast<int>(random.uniform(0.0, 4.0));
        wood.alpha = random.uniform(3.0, 12.0);
        wood.steps = random.uniform() < 0.7 ? 500 : static_cast<int>(random.uniform(0.0, 100.0));
        wood.packing = random.uniform() < 0.9 ? StrandPacking::Rest : StrandPacking::Pbd;
        wood.smoothing = random.uniform();
    });
    if (random.uniform() < 0.7)
        shapeAtRandom(builder, random);
    const Tree first = builder.tree;
    std::shared_ptr<const StrandWood> last = woodOf(builder.tree, nullptr);
    for (int edit = 0; edit < 8; ++edit) {
        editAtRandom(builder, random);
        const auto wood = woodOf(builder.tree, last.get());
        QCOMPARE(difference(*wood, *woodOf(builder.tree, nullptr)), QString());
        last = wood;
    }
    // Back to the first tree, as by undo: what was pruned comes again.
    QCOMPARE(difference(*woodOf(first, last.get()), *woodOf(first, nullptr)), QString());
}

void StrandMesherTest::smallEdit_leavesMostOfTheMesh_data()
{
    QTest::addColumn<bool>("prunes");
    QTest::addRow("profile") << false;
    QTest::addRow("prune") << true;
}

void StrandMesherTest::smallEdit_leavesMostOfTheMesh()
{
    QFETCH(bool, prunes);
    TreeBuilder builder = forkedTree(2000);
    const auto last = woodOf(builder.tree, nullptr);
    QCOMPARE(last->taken, 0U);
    InternodeId limb = 0; // Of less than a twentieth of the tree
    while (builder.index.tipCount(limb) > builder.index.tipCount(0) / 20)
        limb = builder.index.firstChild(limb);
    builder.apply(prunes ? prune(builder.tree, builder.index, std::array{limb})
                         : profileChange(builder.tree, 2, profileOf(ProfileShape::CShape)));
    const auto wood = woodOf(builder.tree, last.get());
    const double taken =
        static_cast<double>(wood->taken) / static_cast<double>(wood->layouts->skeleton().nodes.size());
    QVERIFY2(taken > (prunes ? 0.7 : 0.98) && taken < 1.0, qPrintable(QString::number(taken)));
}

void StrandMesherTest::cancelledMesh_isNone()
{
    const TreeBuilder builder = raisedTree(500, 3);
    const auto layouts = std::make_shared<const StrandLayouts>(builder.tree, builder.index,
                                                               Widths(builder.tree, builder.index));
    WorkProgress progress;
    QVERIFY(meshStrands(layouts, builder.tree.parameters(), {}, nullptr, progress));
    QCOMPARE(progress.share(), 1.0F);
    progress.cancel();
    QVERIFY(!meshStrands(layouts, builder.tree.parameters(), {}, nullptr, progress));
}

void StrandMesherTest::textureCoordinates_areContinuousAcrossEdges()
{
    const TreeBuilder builder = raisedTree(800, 5);
    const BranchMesh mesh = strandMesh(builder);
    // No triangle spans more than half of a texture, so none shows the whole image squeezed; but where a ring
    // of bark begins at a fork, one triangle must.
    double wide = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto internode = [&](std::size_t k) { return mesh.origins[mesh.indices[i + k]].internode; };
        if (internode(0) != internode(1) || internode(0) != internode(2))
            continue;
        float least = 1e9F;
        float most = -1e9F;
        for (std::size_t k = 0; k < 3; ++k) {
            const float u = mesh.vertices[mesh.indices[i + k]].uv[0];
            QVERIFY(std::isfinite(u));
            least = std::min(least, u);
            most = std::max(most, u);
        }
        const auto corner = [&](std::size_t k) {
            return toVec3(mesh.vertices[mesh.indices[i + k]].position);
        };
        const double area = double{(corner(1) - corner(0)).cross(corner(2) - corner(0)).norm()};
        all += area;
        wide += most - least > 0.5F ? area : 0.0;
    }
    QVERIFY2(wide < 0.02 * all, qPrintable(QString::number(wide / all)));
}

void StrandMesherTest::coarserMeshes_haveFewerTrianglesAndAreClosed_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 12; ++seed)
        QTest::addRow("%d", seed) << seed;
}

void StrandMesherTest::coarserMeshes_haveFewerTrianglesAndAreClosed()
{
    QFETCH(int, seed);
    TreeBuilder builder =
        raisedTree(300U + 100U * static_cast<std::uint32_t>(seed), static_cast<std::uint64_t>(seed) + 7);
    Random random(static_cast<std::uint64_t>(seed), 0, 0, Purpose::Leaf);
    if (seed % 2 == 1)
        shapeAtRandom(builder, random);
    std::size_t before = std::numeric_limits<std::size_t>::max();
    for (const double tolerance : {0.001, 0.004, 0.1}) {
        const BranchMesh mesh = strandMesh(builder, {.tolerance = tolerance});
        verifyClosed(mesh, 1);
        QVERIFY2(mesh.indices.size() <= before, qPrintable(QString::number(tolerance)));
        before = mesh.indices.size();
    }
}

void StrandMesherTest::greaterAlpha_needsFewerInnerWalls()
{
    TreeBuilder builder = raisedTree(2000, 4);
    std::vector<std::size_t> sizes;
    for (const double alpha : {3.0, 20.0, 100.0}) {
        setWood(builder, [&](WoodParameters& wood) {
            wood.alpha = alpha;
            wood.strandsPerTip = 5;
        });
        const BranchMesh mesh = strandMesh(builder);
        verifyClosed(mesh, 1);
        sizes.push_back(mesh.vertices.size());
    }
    // Joined sections have no inner walls, so they need fewer vertices.
    QVERIFY(sizes[2] < sizes[1]);
    QVERIFY(sizes[1] < sizes[0]);
}

void StrandMesherTest::severalRoots_areSurfacesEach()
{
    TreeBuilder builder = raisedTree(300, 6);
    builder.apply(rootBirth(builder.tree, builder.index, Vec3(3.0F, 8.0F, 0.0F)));
    const BranchMesh mesh = strandMesh(builder);
    verifyClosed(mesh, 2);
    QCOMPARE(checkSurface(mesh).components, 2U);
}

const TestClass<StrandMesherTest> strandMesherTest;

} // namespace espalier::test

#include "StrandMesherTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/MeshPool.h"

#include "model/mesh/TubeMesher.h"
#include "model/mesh/Tubes.h"
#include "model/mesh/WoodMesh.h"
#include "tests/support/PlacedLeaves.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <tbb/global_control.h>

namespace espalier::test {

class MeshPoolTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void runs_areReusedAndNeverOverlap();
    void capacities_haveLittleSlack();
    void pool_ofARebuiltTree_isExact();
    void pool_followsGrowthPruningAndReversal_data();
    void pool_followsGrowthPruningAndReversal();
    void finish_afterManyChanges_isAsAfterEach();
    void finishedInParts_itIsTheSame();
    void pool_followsParameters();
    void pool_followsPlacedLeaves();
    void placedLeaf_touchesTheLeavesOfItsPieceAlone();
    void pool_followsTheTolerance();
    void lines_moveLeavesAlone();
    void pool_followsAStemThatTapersByLength();
    void pool_followsWidthConstraints();
    void widthConstraint_meshesWhatItChangesAlone();
    void changes_areAllReported();
    void changes_areSortedAndApart();
    void pool_isTheSameOnOneThreadAndMany();
    void update_touchesWhatChangedAlone();
    void applyAndRevert_overAndOver_needNoMoreRoom();
};

namespace {

/// A fault of the pool's bookkeeping, or of its wood and leaves beyond @p tolerance; empty if there is none.
QString faultOf(const MeshPool& pool, const TreeBuilder& builder, float tolerance)
{
    const Tree& tree = builder.tree;
    const TreeIndex& index = builder.index;
    const Widths widths(tree, index);
    const LeafPlacer placer(tree, index, widths);
    TubeMesher mesher(tree, index, widths, pool.options());
    std::vector<std::uint8_t> usedIndices(pool.indices().size(), 0);
    std::vector<std::uint8_t> usedLeaves(pool.leaves().size(), 0);
    std::vector<std::uint8_t> usedVertices(pool.vertices().size(), 0);
    const auto take = [](std::vector<std::uint8_t>& used, const Run& run) {
        for (std::uint32_t i = run.first; i < run.first + run.capacity; ++i) {
            if (i >= used.size() || used[i]++ != 0)
                return false;
        }
        return true;
    };

    for (InternodeId base = 0; base < tree.size(); ++base) {
        const bool expected = tree.isAlive(base) && beginsTube(tree, index, base);
        const MeshPool::Piece* tube = pool.piece(base);
        if (expected != (tube != nullptr))
            return QStringLiteral("tube %1 should%2 be there").arg(base).arg(expected ? "" : " not");
        if (!expected)
            continue;
        if (!take(usedVertices, tube->vertices) || !take(usedIndices, tube->indices) ||
            !take(usedLeaves, tube->leaves))
            return QStringLiteral("runs of tube %1 overlap others").arg(base);

        const MeshSize size = mesher.prepare(base);
        if (tolerance == 0.0F && !(size == tube->size))
            return QStringLiteral("tube %1 has another size").arg(base);
        const InternodeId parent = tree.parent(base);
        if (parent != kNoInternode) {
            const float radius = widths.radius(index, parent);
            if (std::abs(radius - pool.tracker().supportRadius(base)) > tolerance * radius)
                return QStringLiteral("tube %1 leaves a parent of another width").arg(base);
        }
        for (std::size_t i = 0; i < mesher.internodes().size(); ++i) {
            const InternodeId id = mesher.internodes()[i];
            if (std::abs(pool.tracker().meshedRadius(id) - mesher.radii()[i]) > tolerance * mesher.radii()[i])
                return QStringLiteral("internode %1 has another width").arg(id);
        }
        if (tolerance == 0.0F) {
            std::vector<MeshVertex> vertices(size.vertices);
            std::vector<VertexIndex> indices(size.indices);
            mesher.write(vertices, indices, tube->vertices.first);
            if (!std::ranges::equal(vertices, pool.vertices().subspan(tube->vertices.first, size.vertices)) ||
                !std::ranges::equal(indices, pool.indices().subspan(tube->indices.first, size.indices)))
                return QStringLiteral("tube %1 is not as if meshed now").arg(base);
        }
        for (const VertexIndex vertex : pool.indices().subspan(tube->indices.first, tube->size.indices)) {
            if (vertex < tube->vertices.first || vertex >= tube->vertices.first + tube->size.vertices)
                return QStringLiteral("tube %1 refers to another's vertices").arg(base);
        }
        for (std::uint32_t i = tube->size.indices; i < tube->indices.capacity; ++i) {
            if (pool.indices()[tube->indices.first + i] != 0)
                return QStringLiteral("tube %1 has leftover triangles").arg(base);
        }

        // Leaves stand on bark that is as exact as the wood.
        const float thickest = std::max(mesher.supportRadius(), std::ranges::max(mesher.radii()));
        std::vector<LeafInstance> leaves(placer.count(mesher.internodes()));
        placer.place(mesher.internodes(), leaves);
        const auto isAsPlaced = [&](const LeafInstance& there, const LeafInstance& placed) {
            LeafInstance moved = there;
            // How far a leaf near the ground turns up, in steps, depends on where exactly it stands.
            if (tolerance > 0.0F && placed.position[1] < 2.0F * (placed.width + placed.length)) {
                moved.rotation = placed.rotation;
                moved.length = placed.length;
            }
            moved.position = placed.position;
            return moved == placed &&
                   (toVec3(there.position) - toVec3(placed.position)).norm() <= 10.0F * tolerance * thickest;
        };
        if (!std::ranges::equal(pool.leaves().subspan(tube->leaves.first, tube->leafCount), leaves,
                                isAsPlaced))
            return QStringLiteral("tube %1 has other leaves").arg(base);
        for (std::uint32_t i = tube->leafCount; i < tube->leaves.capacity; ++i) {
            if (pool.leaves()[tube->leaves.first + i].length != 0.0F)
                return QStringLiteral("tube %1 has leftover leaves").arg(base);
        }
    }
    for (std::size_t i = 0; i < usedIndices.size(); ++i) {
        if (usedIndices[i] == 0 && pool.indices()[i] != 0)
            return QStringLiteral("a triangle belongs to no tube");
    }
    for (std::size_t i = 0; i < usedLeaves.size(); ++i) {
        if (usedLeaves[i] == 0 && pool.leaves()[i].length != 0.0F)
            return QStringLiteral("a leaf belongs to no tube");
    }
    return {};
}

/// A tree and its pool, changed at random.
struct Follower {
    explicit Follower(std::uint32_t count, std::uint64_t seed = 1, const TreeParameters& parameters = {})
        : builder(randomTree(count, seed, parameters)), random(seed, 0, 0, Purpose::Direction)
    {
        pool.rebuild(builder.tree, builder.index);
    }

    /// Notes the change, and meshes it unless told to wait.
    void follow(const TreeDelta& delta)
    {
        pool.follow(builder.tree, builder.index, delta);
        if (!waits)
            pool.finish(builder.tree, builder.index);
    }
    void apply(TreeDelta delta) { follow(builder.apply(std::move(delta))); }
    void revert()
    {
        undone.push_back(builder.revert());
        follow(undone.back());
    }
    void applyAgain()
    {
        apply(std::move(undone.back()));
        undone.pop_back();
    }
    void grow(std::uint32_t count)
    {
        undone.clear();
        apply(randomGrowth(builder.tree, count, random.bits()));
    }
    void prune()
    {
        undone.clear();
        const auto id = static_cast<InternodeId>(random.bits() % builder.tree.size());
        if (id != 0 && builder.tree.isAlive(id) &&
            builder.index.subtreeSize(id) < builder.index.livingCount() / 3)
            apply(death(builder.tree, builder.index, id));
    }
    void bendAtRandom()
    {
        undone.clear();
        const auto id = static_cast<InternodeId>(random.bits() % builder.tree.size());
        const Rotation turn(Eigen::AngleAxisf(0.4F, random.direction()));
        if (builder.tree.isAlive(id))
            apply(bend(builder.tree, id, turn, 1.2F));
    }
    void setWidth(InternodeId id, float diameter)
    {
        undone.clear();
        apply(widthChange(builder.tree, id, diameter));
    }
    void removeWidths()
    {
        while (!builder.tree.widthConstraints().empty())
            setWidth(builder.tree.widthConstraints().front().id, 0.0F);
    }
    /// Growth, pruning, bending, undo or redo.
    void actAtRandom()
    {
        const std::uint64_t choice = random.bits() % 11;
        if (choice == 10)
            bendAtRandom();
        else if (choice < 4)
            grow(1 + static_cast<std::uint32_t>(random.bits() % 30));
        else if (choice < 6)
            prune();
        else if (choice < 8 && builder.journal.size() > 1)
            revert();
        else if (!undone.empty())
            applyAgain();
    }

    TreeBuilder builder;
    MeshPool pool;
    bool waits = false;
    std::vector<TreeDelta> undone;
    Random random;
};

} // namespace

void MeshPoolTest::runs_areReusedAndNeverOverlap()
{
    RunAllocator runs;
    Random random(1, 0, 0, Purpose::Direction);
    std::vector<Run> taken;
    std::vector<std::uint8_t> used(200000, 0);
    for (int i = 0; i < 3000; ++i) {
        if (taken.size() > 100 && random.uniform() < 0.5) {
            std::swap(taken[random.bits() % taken.size()], taken.back());
            const Run run = taken.back();
            taken.pop_back();
            std::fill_n(used.begin() + run.first, run.capacity, std::uint8_t{0});
            runs.release(run);
            continue;
        }
        const auto count = static_cast<std::uint32_t>(1 + random.bits() % 200);
        taken.push_back(runs.allocate(count));
        const Run& run = taken.back();
        QVERIFY(run.capacity >= count);
        QVERIFY(run.first + run.capacity <= runs.end());
        for (std::uint32_t place = run.first; place < run.first + run.capacity; ++place)
            QVERIFY(used[place]++ == 0);
    }
    const std::uint32_t end = runs.end();
    const std::vector<Run> last = taken;
    for (const Run& run : last)
        runs.release(run);
    for (const Run& run : last)
        runs.allocate(run.capacity);
    QCOMPARE(runs.end(), end);
    QVERIFY(RunAllocator().allocate(0) == Run{});
}

void MeshPoolTest::capacities_haveLittleSlack()
{
    std::uint32_t below = 0;
    for (std::uint32_t count = 0; count < 100000; ++count) {
        const std::uint32_t capacity = RunAllocator::capacityFor(count);
        QVERIFY(capacity >= count && capacity >= below);
        QCOMPARE(RunAllocator::capacityFor(capacity), capacity);
        QVERIFY(count < 16 ? capacity < count + 4 : capacity * 4 < count * 5 + 4);
        below = capacity;
    }
}

void MeshPoolTest::pool_ofARebuiltTree_isExact()
{
    for (const std::uint64_t seed : {1U, 2U}) {
        Follower follower(1500, seed);
        QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
        QVERIFY(!follower.pool.settle(follower.builder.tree, follower.builder.index));
    }
}

void MeshPoolTest::pool_followsGrowthPruningAndReversal_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<double>("baseDiameter");
    QTest::addColumn<int>("laterals");
    QTest::addColumn<int>("maxTips");
    QTest::newRow("usual") << 1 << 0.0 << 1 << 3;
    QTest::newRow("three buds a node") << 2 << 0.0 << 3 << 3;
    // Then every tip changes all widths a little.
    QTest::newRow("base diameter set") << 3 << 0.3 << 2 << 3;
    // Then a branch may lose or regain its leaves while its width is within the tolerance.
    QTest::newRow("leaves on thick branches") << 4 << 0.0 << 2 << 60;
}

void MeshPoolTest::pool_followsGrowthPruningAndReversal()
{
    QFETCH(int, seed);
    QFETCH(double, baseDiameter);
    QFETCH(int, laterals);
    QFETCH(int, maxTips);
    TreeParameters parameters;
    parameters.widths.baseDiameter = baseDiameter;
    parameters.growth.lateralsPerNode = laterals;
    parameters.leaves.maxTips = maxTips;
    Follower follower(250, static_cast<std::uint64_t>(seed), parameters);
    for (int step = 0; step < 150; ++step) {
        follower.actAtRandom();
        QCOMPARE(faultOf(follower.pool, follower.builder, WoodTracker::kTolerance + 0.001F), QString());
        if (step % 10 == 9) {
            follower.pool.settle(follower.builder.tree, follower.builder.index);
            QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
        }
    }
    // All the way back to the seedling.
    while (!follower.builder.journal.empty())
        follower.revert();
    follower.pool.settle(follower.builder.tree, follower.builder.index);
    QCOMPARE(follower.builder.index.livingCount(), 1U);
    QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
}

void MeshPoolTest::finish_afterManyChanges_isAsAfterEach()
{
    for (const double baseDiameter : {0.0, 0.3}) {
        TreeParameters parameters;
        parameters.widths.baseDiameter = baseDiameter;
        parameters.growth.lateralsPerNode = 2;
        Follower follower(300, 11, parameters);
        follower.waits = true;
        for (int frame = 0; frame < 25; ++frame) {
            for (int step = 0; step < 12; ++step) {
                follower.actAtRandom();
                if (step == 5 && frame % 5 == 4) {
                    follower.undone.clear();
                    TreeParameters changed = follower.builder.tree.parameters();
                    changed.leaves.perNode = 1 + frame % 4;
                    changed.widths.tipDiameter *= frame % 2 == 0 ? 1.1 : 1.0;
                    follower.apply(parameterChange(follower.builder.tree, changed));
                }
            }
            follower.pool.finish(follower.builder.tree, follower.builder.index);
            QCOMPARE(faultOf(follower.pool, follower.builder, WoodTracker::kTolerance + 0.001F), QString());
            if (frame % 3 == 2) {
                follower.pool.settle(follower.builder.tree, follower.builder.index);
                QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
            }
        }
    }
}

void MeshPoolTest::finishedInParts_itIsTheSame()
{
    for (const double baseDiameter : {0.0, 0.25}) {
        TreeParameters parameters;
        parameters.widths.baseDiameter = baseDiameter;
        parameters.growth.lateralsPerNode = 2;
        Follower follower(400, 21, parameters);
        follower.waits = true;
        const auto some = [&](std::size_t tubes) {
            return follower.pool.finishSome(follower.builder.tree, follower.builder.index, tubes);
        };
        int unfinished = 0;
        for (int step = 0; step < 400; ++step) {
            follower.actAtRandom();
            if (step % 40 == 20) {
                follower.undone.clear();
                TreeParameters changed = follower.builder.tree.parameters();
                changed.leaves.perNode = 1 + step / 40 % 4;
                changed.widths.tipDiameter *= step % 80 == 20 ? 1.1 : 1.0;
                changed.bark.scale *= step % 120 == 20 ? 1.5 : 1.0;
                follower.apply(parameterChange(follower.builder.tree, changed));
            }
            // The tree changes while tubes of its previous state wait.
            unfinished += some(follower.random.bits() % 12) ? 0 : 1;
            if (step % 25 == 24) {
                while (!some(7)) {
                }
                QCOMPARE(faultOf(follower.pool, follower.builder, WoodTracker::kTolerance + 0.001F),
                         QString());
            }
            if (step % 50 == 49) {
                follower.pool.noteInexact(follower.builder.tree, follower.builder.index);
                while (!some(7)) {
                }
                QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
            }
        }
        QVERIFY(unfinished > 100);
    }
}

void MeshPoolTest::pool_followsParameters()
{
    Follower follower(600, 5);
    const auto change = [&](auto&& edit) {
        TreeParameters parameters = follower.builder.tree.parameters();
        edit(parameters);
        follower.apply(parameterChange(follower.builder.tree, parameters));
        return faultOf(follower.pool, follower.builder, 0.0F);
    };
    QCOMPARE(change([](TreeParameters& p) { p.widths.tipDiameter = 0.006; }), QString());
    QCOMPARE(change([](TreeParameters& p) { p.bark.scale = 0.05; }), QString());
    QCOMPARE(change([](TreeParameters& p) { p.leaves.perNode = 5; }), QString());
    QCOMPARE(change([](TreeParameters& p) { p.leaves.maxTips = 30; }), QString());
    QCOMPARE(change([](TreeParameters& p) { p.growth.irregularity = 0.9; }), QString());
    QCOMPARE(change([](TreeParameters& p) { p.leaves.visible = false; }), QString());
    for (const LeafInstance& leaf : follower.pool.leaves())
        QCOMPARE(leaf.length, 0.0F);
    follower.revert();
    QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
    QCOMPARE(change([](TreeParameters& p) { p.growth.apicalDominance = 0.6; }), QString());
}

void MeshPoolTest::pool_followsPlacedLeaves()
{
    TreeParameters parameters;
    parameters.leaves.maxTips = 2;
    for (const bool waits : {false, true}) {
        Follower follower(300, 7, parameters);
        follower.waits = waits;
        std::uint64_t most = 0;
        for (int step = 0; step < 120; ++step) {
            most = std::max(most, placedLeafCount(follower.builder.tree));
            if (follower.random.uniform() < 0.5) {
                follower.undone.clear();
                follower.apply(randomLeafEdit(follower.builder.tree, follower.random));
            } else {
                follower.actAtRandom();
            }
            if (waits && step % 10 != 9)
                continue;
            while (!follower.pool.finishSome(follower.builder.tree, follower.builder.index, 3)) {
            }
            QCOMPARE(faultOf(follower.pool, follower.builder, WoodTracker::kTolerance + 0.001F), QString());
        }
        QVERIFY(most > 10);
        follower.pool.settle(follower.builder.tree, follower.builder.index);
        QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
    }
}

void MeshPoolTest::placedLeaf_touchesTheLeavesOfItsPieceAlone()
{
    Follower follower(4000, 9);
    follower.pool.takeChanges();
    const InternodeId tip = follower.builder.tree.size() - 1;
    const auto expectFewLeaves = [&] {
        const MeshPool::Changes changes = follower.pool.takeChanges();
        QVERIFY(changes.vertices.empty() && changes.indices.empty());
        std::uint32_t rewritten = 0;
        for (const MeshPool::Range& range : changes.leaves)
            rewritten += range.end - range.begin;
        QVERIFY(rewritten > 0);
        QVERIFY(rewritten < follower.pool.leaves().size() / 5);
        QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
    };
    follower.pool.settle(follower.builder.tree, follower.builder.index);
    follower.pool.takeChanges();
    TreeDelta placed = deltaStartingAt(follower.builder.tree);
    addLeaf(placed, leafAround(tip, 0.5F, 1.0));
    follower.apply(std::move(placed));
    expectFewLeaves();
    TreeDelta moved = deltaStartingAt(follower.builder.tree);
    moveLeaf(moved, follower.builder.tree, 0, leafAround(tip - 40, 0.5F, 2.0, 0.2F));
    follower.apply(std::move(moved));
    expectFewLeaves();
    follower.apply(leafRemoval(follower.builder.tree, 0));
    expectFewLeaves();
    for (int i = 0; i < 3; ++i) {
        follower.revert();
        expectFewLeaves();
    }
}

void MeshPoolTest::pool_followsTheTolerance()
{
    Follower follower(600, 6);
    const std::size_t before = follower.pool.vertices().size();
    follower.pool.setOptions({.tolerance = 6e-5});
    while (!follower.pool.finishSome(follower.builder.tree, follower.builder.index, 50)) {
    }
    QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
    QVERIFY(follower.pool.vertices().size() > 2 * before);
    follower.grow(20);
    QCOMPARE(faultOf(follower.pool, follower.builder, WoodTracker::kTolerance + 0.001F), QString());
}

void MeshPoolTest::lines_moveLeavesAlone()
{
    TreeParameters parameters;
    parameters.wood.mesher = WoodMesherKind::Strands;
    Follower follower(500, 8, parameters);
    const Tree& tree = follower.builder.tree;
    const TreeIndex& index = follower.builder.index;
    const auto sorted = [](std::span<const LeafInstance> leaves) {
        std::vector<std::array<float, 3>> places;
        for (const LeafInstance& leaf : leaves) {
            if (leaf.length > 0.0F)
                places.push_back(leaf.position);
        }
        std::ranges::sort(places);
        return places;
    };
    const auto onTubes = sorted(follower.pool.leaves());
    const Widths widths(tree, index);
    const ShownWood wood(tree, index, widths);
    const auto lines = std::make_shared<const StrandLines>(wood.lines());
    follower.pool.takeChanges();
    follower.pool.setLines(lines);
    while (!follower.pool.finishSome(tree, index, 40)) {
    }
    const MeshPool::Changes changes = follower.pool.takeChanges();
    QVERIFY(changes.vertices.empty() && changes.indices.empty() && !changes.leaves.empty());
    QVERIFY(sorted(follower.pool.leaves()) == sorted(wood.leaves()));
    QVERIFY(sorted(follower.pool.leaves()) != onTubes);
    follower.pool.setLines(lines);
    follower.pool.finish(tree, index);
    QVERIFY(follower.pool.takeChanges().isEmpty());
    follower.pool.setLines(nullptr);
    follower.pool.finish(tree, index);
    QVERIFY(sorted(follower.pool.leaves()) == onTubes);
}

void MeshPoolTest::pool_followsAStemThatTapersByLength()
{
    TreeParameters parameters;
    parameters.widths.baseDiameter = 0.12;
    TreeBuilder builder(1, parameters);
    MeshPool pool;
    pool.rebuild(builder.tree, builder.index);
    const auto fault = [&] {
        pool.follow(builder.tree, builder.index, builder.journal.back());
        pool.settle(builder.tree, builder.index);
        return faultOf(pool, builder, 0.0F);
    };
    InternodeId tip = 0;
    for (int i = 0; i < 12; ++i) {
        tip = builder.grow({.parent = tip, .rotation = continuing()});
        QCOMPARE(fault(), QString());
    }
    // It branches, and is pruned to a single stem again.
    const InternodeId lateral = builder.grow({.parent = tip - 4, .slot = 0, .rotation = branching(0.8)});
    QCOMPARE(fault(), QString());
    builder.apply(death(builder.tree, builder.index, lateral));
    QCOMPARE(fault(), QString());
}

void MeshPoolTest::pool_followsWidthConstraints()
{
    for (const double baseDiameter : {0.0, 0.3}) {
        TreeParameters parameters;
        parameters.widths.baseDiameter = baseDiameter;
        parameters.growth.lateralsPerNode = 2;
        Follower follower(400, 12, parameters);
        follower.waits = true;
        for (int step = 0; step < 120; ++step) {
            const std::uint64_t choice = follower.random.bits() % 8;
            if (choice == 0)
                follower.removeWidths();
            else if (choice < 4)
                follower.setWidth(static_cast<InternodeId>(follower.random.bits() % 300),
                                  static_cast<float>(follower.random.uniform(0.004, 0.2)));
            for (std::uint64_t i = 0; i < 3 + choice; ++i)
                follower.actAtRandom();
            follower.pool.finish(follower.builder.tree, follower.builder.index);
            QCOMPARE(faultOf(follower.pool, follower.builder, WoodTracker::kTolerance + 0.001F), QString());
            if (step % 10 == 9) {
                follower.pool.settle(follower.builder.tree, follower.builder.index);
                QCOMPARE(faultOf(follower.pool, follower.builder, 0.0F), QString());
            }
        }
    }
}

void MeshPoolTest::widthConstraint_meshesWhatItChangesAlone()
{
    Follower follower(3000, 13);
    const TreeIndex& index = follower.builder.index;
    InternodeId branch = 100;
    while (index.tipCount(branch) < 4 || index.tipCount(branch) > 30)
        ++branch;
    // A constraint below it stops the change from reaching the trunk.
    const InternodeId below = follower.builder.tree.parent(branch);
    const float radius = Widths(follower.builder.tree, index).radius(index, below);
    follower.setWidth(below, 2.0F * radius);
    follower.setWidth(branch, 1.2F * radius);
    follower.pool.settle(follower.builder.tree, index);
    follower.pool.takeChanges();
    follower.setWidth(branch, 1.56F * radius);
    std::size_t sent = 0;
    for (const MeshPool::Range& range : follower.pool.takeChanges().vertices)
        sent += range.end - range.begin;
    QVERIFY(sent > 0);
    QVERIFY(sent < follower.pool.vertices().size() / 4);
}

void MeshPoolTest::changes_areAllReported()
{
    // A copy that takes only the reported ranges stays equal.
    Follower follower(400, 6);
    std::vector<MeshVertex> vertices;
    std::vector<VertexIndex> indices;
    std::vector<LeafInstance> leaves;
    const auto take = [](auto& copy, const auto& original, const std::vector<MeshPool::Range>& ranges) {
        copy.resize(original.size());
        for (const MeshPool::Range& range : ranges)
            std::copy(original.begin() + range.begin, original.begin() + range.end,
                      copy.begin() + range.begin);
    };
    for (int step = 0; step < 120; ++step) {
        const MeshPool::Changes changes = follower.pool.takeChanges();
        take(vertices, follower.pool.vertices(), changes.vertices);
        take(indices, follower.pool.indices(), changes.indices);
        take(leaves, follower.pool.leaves(), changes.leaves);
        QVERIFY(std::ranges::equal(indices, follower.pool.indices()));
        QVERIFY(std::ranges::equal(leaves, follower.pool.leaves()));
        for (const VertexIndex vertex : indices)
            QVERIFY(vertex == 0 || vertices[vertex] == follower.pool.vertices()[vertex]);
        if (step % 20 == 19)
            follower.pool.settle(follower.builder.tree, follower.builder.index);
        else
            follower.actAtRandom();
    }
}

void MeshPoolTest::changes_areSortedAndApart()
{
    Follower follower(3000, 7);
    MeshPool::Changes changes = follower.pool.takeChanges();
    QVERIFY(!changes.isEmpty());
    QVERIFY(changes.vertices == std::vector{(MeshPool::Range{
                                    0, static_cast<std::uint32_t>(follower.pool.vertices().size())})} ||
            changes.vertices.front().begin == 0);
    QVERIFY(follower.pool.takeChanges().isEmpty());
    for (int step = 0; step < 30; ++step) {
        follower.actAtRandom();
        changes = follower.pool.takeChanges();
        for (const auto& [ranges, size] : {std::pair{changes.vertices, follower.pool.vertices().size()},
                                           std::pair{changes.indices, follower.pool.indices().size()},
                                           std::pair{changes.leaves, follower.pool.leaves().size()}}) {
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                QVERIFY(ranges[i].begin < ranges[i].end && ranges[i].end <= size);
                QVERIFY(i == 0 || ranges[i].begin > ranges[i - 1].end);
            }
        }
    }
}

void MeshPoolTest::pool_isTheSameOnOneThreadAndMany()
{
    const auto run = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Follower follower(4000, 8);
        for (int step = 0; step < 20; ++step)
            follower.grow(150);
        return std::pair(std::vector(follower.pool.indices().begin(), follower.pool.indices().end()),
                         std::vector(follower.pool.leaves().begin(), follower.pool.leaves().end()));
    };
    const auto single = run(1);
    QVERIFY(single == run(4));
}

void MeshPoolTest::update_touchesWhatChangedAlone()
{
    Follower follower(8000, 9);
    follower.pool.takeChanges();
    // One more internode on the youngest twig.
    const InternodeId tip = follower.builder.tree.size() - 1;
    QVERIFY(follower.builder.tree.isAlive(tip));
    const NewInternode born{.parent = tip, .rotation = continuing()};
    follower.apply(births(follower.builder.tree, std::span(&born, 1)));
    const MeshPool::Changes changes = follower.pool.takeChanges();
    std::uint32_t rewritten = 0;
    for (const MeshPool::Range& range : changes.vertices)
        rewritten += range.end - range.begin;
    QVERIFY(rewritten > 0);
    QVERIFY(rewritten < follower.pool.vertices().size() / 50);
}

void MeshPoolTest::applyAndRevert_overAndOver_needNoMoreRoom()
{
    Follower follower(2000, 10);
    follower.grow(100);
    follower.revert();
    follower.applyAgain();
    const std::size_t vertices = follower.pool.vertices().size();
    const std::size_t indices = follower.pool.indices().size();
    const std::size_t leaves = follower.pool.leaves().size();
    for (int i = 0; i < 20; ++i) {
        follower.revert();
        follower.applyAgain();
    }
    QCOMPARE(follower.pool.vertices().size(), vertices);
    QCOMPARE(follower.pool.indices().size(), indices);
    QCOMPARE(follower.pool.leaves().size(), leaves);
}

const TestClass<MeshPoolTest> meshPoolTest;

} // namespace espalier::test

#include "MeshPoolTest.moc"

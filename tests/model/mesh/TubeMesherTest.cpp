// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/TubeMesher.h"

#include "model/mesh/BranchMesher.h"
#include "model/mesh/RingFrame.h"
#include "model/mesh/Tubes.h"
#include "tests/support/MeshTopology.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>
#include <numeric>

namespace espalier::test {

class TubeMesherTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void topologyCheck_tellsSpheresFromToriAndHoles();
    void tubes_partTheTree();
    void tube_goesOnThroughTheTerminalShootOrAMuchStrongerLateral();
    void tube_isAClosedManifoldOfCharacteristicTwo_data();
    void tube_isAClosedManifoldOfCharacteristicTwo();
    void ringVertices_lieAtTheRadius();
    void normals_areUnitAndAcrossTheTangents();
    void normals_pointOutOfTheTriangles();
    void textureCoordinates_runAroundAWholeNumberOfTimes();
    void texels_areSquare();
    void curve_passesThroughTheNodes();
    void curve_ofAThickTube_skipsShortInternodes();
    void radius_atANode_isTheWidth();
    void frames_ofAPlaneCurve_keepTheirBinormal();
    void lateral_startsInsideItsParentAndThinner();
    void trunk_widensTowardTheGround();
    void sides_followTheThickness();
    void sides_keepEveryChordWithinTheTolerance();
    void trunkWithoutTwigs_isRound();
    void coarserTolerance_thinsTheMesh();
    void internodesOfNoLength_areMeshed();
    void nothing_liesBelowTheGround();
    void origins_nameTheInternodeOfEachVertex();
};

namespace {

/// A tube's mesh and the data it was made from.
struct MeshedTube {
    std::vector<MeshVertex> vertices;
    std::vector<VertexIndex> indices;
    std::vector<TubeMesher::Ring> rings;
    std::vector<InternodeId> internodes;
    std::vector<float> radii;
    float parentRadius = 0.0F;

    std::size_t firstVertex(std::size_t ring) const
    {
        return std::accumulate(
            rings.begin(), rings.begin() + static_cast<std::ptrdiff_t>(ring), std::size_t{0},
            [](std::size_t sum, const auto& r) { return sum + static_cast<std::size_t>(r.sides) + 1; });
    }
    const MeshVertex& vertex(std::size_t ring, int side) const
    {
        return vertices[firstVertex(ring) + static_cast<std::size_t>(side)];
    }
};

MeshedTube meshed(const TreeBuilder& builder, InternodeId base, const WoodMeshOptions& options = {})
{
    const Widths widths(builder.tree, builder.index);
    TubeMesher mesher(builder.tree, builder.index, widths, options);
    const MeshSize size = mesher.prepare(base);
    MeshedTube tube;
    tube.vertices.resize(size.vertices);
    tube.indices.resize(size.indices);
    mesher.write(tube.vertices, tube.indices);
    tube.rings.assign(mesher.rings().begin(), mesher.rings().end());
    tube.internodes.assign(mesher.internodes().begin(), mesher.internodes().end());
    tube.radii.assign(mesher.radii().begin(), mesher.radii().end());
    tube.parentRadius = mesher.supportRadius();
    return tube;
}

template <class Visit>
void forEachTube(const TreeBuilder& builder, Visit&& visit)
{
    for (const InternodeId base : tubesOf(builder.tree, builder.index))
        visit(meshed(builder, base));
}

TreeParameters withWidths(double exponent, double baseDiameter, double internodeLength = 0.1)
{
    TreeParameters parameters;
    parameters.widths.exponent = exponent;
    parameters.widths.baseDiameter = baseDiameter;
    parameters.growth.internodeLength = internodeLength;
    return parameters;
}

/// An upright trunk of @p count straight internodes, with a short lateral at every third node.
TreeBuilder fir(std::uint32_t count, const TreeParameters& parameters = {})
{
    TreeBuilder builder(1, parameters);
    InternodeId tip = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const InternodeId next = builder.grow({.parent = tip, .rotation = continuing()});
        if (i % 3 == 1)
            builder.growAxis(tip, 0, branching(1.0), 2);
        tip = next;
    }
    return builder;
}

MeshVertex at(float x, float y, float z)
{
    return {.position = {x, y, z}, .normal = {0, 1, 0}, .tangent = {1, 0, 0, 1}, .uv = {0, 0}};
}

} // namespace

void TubeMesherTest::topologyCheck_tellsSpheresFromToriAndHoles()
{
    const std::vector tetrahedron{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)};
    const std::vector<VertexIndex> faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    QVERIFY(topologyOf(tetrahedron, faces).isClosedManifold());
    QCOMPARE(topologyOf(tetrahedron, faces).eulerCharacteristic, 2);

    // A tube with a through-hole: characteristic 0.
    std::vector<MeshVertex> torus;
    std::vector<VertexIndex> torusFaces;
    constexpr VertexIndex n = 8;
    for (VertexIndex i = 0; i < n; ++i) {
        for (VertexIndex j = 0; j < n; ++j) {
            const double a = 2.0 * std::numbers::pi * i / n;
            const double b = 2.0 * std::numbers::pi * j / n;
            const double r = 2.0 + std::cos(b);
            torus.push_back(at(static_cast<float>(r * std::cos(a)), static_cast<float>(std::sin(b)),
                               static_cast<float>(r * std::sin(a))));
            const VertexIndex right = (i + 1) % n * n + j;
            const VertexIndex up = i * n + (j + 1) % n;
            const VertexIndex corner = (i + 1) % n * n + (j + 1) % n;
            torusFaces.insert(torusFaces.end(), {i * n + j, up, corner, i * n + j, corner, right});
        }
    }
    QVERIFY(topologyOf(torus, torusFaces).isClosedManifold());
    QCOMPARE(topologyOf(torus, torusFaces).eulerCharacteristic, 0);

    const std::span open(faces.data(), 9);
    QCOMPARE(topologyOf(tetrahedron, open).openEdges, 3);
    const std::vector<VertexIndex> inverted{0, 1, 2, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    QCOMPARE(topologyOf(tetrahedron, inverted).isClosedManifold(), false);
    const std::vector<VertexIndex> flat{0, 1, 1};
    QCOMPARE(topologyOf(tetrahedron, flat).degenerateTriangles, 1);
}

void TubeMesherTest::tubes_partTheTree()
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        TreeBuilder builder = raisedTree(700, seed);
        builder.apply(death(builder.tree, builder.index, 300));
        std::vector<int> seen(builder.tree.size(), 0);
        forEachTube(builder, [&](const MeshedTube& tube) {
            for (std::size_t i = 0; i < tube.internodes.size(); ++i) {
                ++seen[tube.internodes[i]];
                if (i > 0)
                    QCOMPARE(builder.tree.parent(tube.internodes[i]), tube.internodes[i - 1]);
            }
        });
        for (InternodeId id = 0; id < builder.tree.size(); ++id)
            QCOMPARE(seen[id], builder.tree.isAlive(id) ? 1 : 0);
        // Every tube ends in a tip.
        QCOMPARE(tubesOf(builder.tree, builder.index).size(), std::size_t{builder.index.tipCount(0)});
    }
}

void TubeMesherTest::tube_goesOnThroughTheTerminalShootOrAMuchStrongerLateral()
{
    TreeParameters parameters;
    parameters.growth.lateralsPerNode = 4;
    TreeBuilder builder(1, parameters);
    const InternodeId node = builder.grow({.rotation = continuing()});
    QCOMPARE(tubeContinuation(builder.index, node), kNoInternode);
    const InternodeId lateral = builder.grow({.parent = node, .slot = 1, .rotation = branching(0.8, 1, 4)});
    QCOMPARE(tubeContinuation(builder.index, node), lateral);
    const InternodeId main = builder.grow({.parent = node, .rotation = continuing()});
    QCOMPARE(tubeContinuation(builder.index, node), main);
    for (const int slot : {0, 1})
        builder.grow({.parent = lateral, .slot = slot, .rotation = branching(0.8, slot, 4)});
    QCOMPARE(builder.index.tipCount(lateral), 2U);
    QCOMPARE(tubeContinuation(builder.index, node), main);
    builder.grow({.parent = lateral, .slot = 2, .rotation = branching(0.8, 2, 4)});
    QCOMPARE(tubeContinuation(builder.index, node), lateral);
    builder.revert();
    QCOMPARE(tubeContinuation(builder.index, node), main);
}

void TubeMesherTest::tube_isAClosedManifoldOfCharacteristicTwo_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<double>("exponent");
    QTest::addColumn<double>("baseDiameter");
    QTest::addColumn<double>("internodeLength");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("usual") << 1 << 2.2 << 0.0 << 0.1 << 1e-3;
    QTest::newRow("thick trunk") << 2 << 2.2 << 0.6 << 0.1 << 1e-3;
    QTest::newRow("thicker than long") << 3 << 2.0 << 3.0 << 0.02 << 1e-3;
    QTest::newRow("hardly tapered") << 4 << 6.0 << 0.0 << 0.1 << 1e-3;
    QTest::newRow("coarse") << 5 << 2.2 << 0.4 << 0.1 << 0.02;
    QTest::newRow("fine") << 6 << 2.2 << 0.4 << 0.1 << 1e-4;
}

void TubeMesherTest::tube_isAClosedManifoldOfCharacteristicTwo()
{
    QFETCH(int, seed);
    QFETCH(double, exponent);
    QFETCH(double, baseDiameter);
    QFETCH(double, internodeLength);
    QFETCH(double, tolerance);
    const TreeBuilder builder = raisedTree(600, static_cast<std::uint64_t>(seed),
                                           withWidths(exponent, baseDiameter, internodeLength));
    for (const InternodeId base : tubesOf(builder.tree, builder.index)) {
        const MeshedTube tube = meshed(builder, base, {.tolerance = tolerance});
        const MeshTopology topology = topologyOf(tube.vertices, tube.indices);
        QCOMPARE(topology.openEdges, 0);
        QCOMPARE(topology.nonManifoldEdges, 0);
        QCOMPARE(topology.degenerateTriangles, 0);
        QCOMPARE(topology.eulerCharacteristic, 2);
    }
}

void TubeMesherTest::ringVertices_lieAtTheRadius()
{
    const TreeBuilder builder = raisedTree(600, 3, withWidths(2.2, 0.4));
    forEachTube(builder, [&](const MeshedTube& tube) {
        for (std::size_t i = 0; i < tube.rings.size(); ++i) {
            const TubeMesher::Ring& ring = tube.rings[i];
            for (int side = 0; side <= ring.sides; ++side) {
                const Vec3 spoke = toVec3(tube.vertex(i, side).position) - ring.centre;
                const float rounding = 1e-6F * std::max(1.0F, ring.centre.norm());
                QVERIFY(std::abs(spoke.norm() - ring.radius) <= rounding);
                QVERIFY(std::abs(spoke.dot(ring.tangent)) <= rounding);
            }
        }
    });
}

void TubeMesherTest::normals_areUnitAndAcrossTheTangents()
{
    const TreeBuilder builder = raisedTree(600, 4, withWidths(2.2, 0.4));
    forEachTube(builder, [&](const MeshedTube& tube) {
        for (const MeshVertex& vertex : tube.vertices) {
            const Vec3 normal = toVec3(vertex.normal);
            const Vec3 tangent(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]);
            QVERIFY(std::abs(normal.norm() - 1.0F) < 1e-5F);
            QVERIFY(std::abs(tangent.norm() - 1.0F) < 1e-5F);
            QVERIFY(std::abs(normal.dot(tangent)) < 1e-5F);
            QCOMPARE(vertex.tangent[3], 1.0F);
        }
        // The bitangent leads up the tube, toward rising v; the tangent to the next side, toward rising u.
        for (std::size_t i = 0; i + 1 < tube.rings.size(); ++i) {
            for (int side = 0; side < tube.rings[i].sides; ++side) {
                const MeshVertex& vertex = tube.vertex(i, side);
                const Vec3 tangent(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]);
                QVERIFY(toVec3(vertex.normal).cross(tangent).dot(tube.rings[i].tangent) > 0.0F);
                const Vec3 next = toVec3(tube.vertex(i, side + 1).position) - toVec3(vertex.position);
                QVERIFY(next.dot(tangent) > 0.0F);
            }
        }
    });
}

void TubeMesherTest::normals_pointOutOfTheTriangles()
{
    const TreeBuilder builder = fir(60);
    forEachTube(builder, [&](const MeshedTube& tube) {
        const std::size_t baseCap = 3 * static_cast<std::size_t>(tube.rings.front().sides - 2);
        for (std::size_t i = baseCap; i < tube.indices.size(); i += 3) {
            const MeshVertex& a = tube.vertices[tube.indices[i]];
            const MeshVertex& b = tube.vertices[tube.indices[i + 1]];
            const MeshVertex& c = tube.vertices[tube.indices[i + 2]];
            const Vec3 face = (toVec3(b.position) - toVec3(a.position))
                                  .cross(toVec3(c.position) - toVec3(a.position))
                                  .normalized();
            for (const MeshVertex* vertex : {&a, &b, &c})
                QVERIFY(face.dot(toVec3(vertex->normal)) > 0.3F);
        }
    });
}

void TubeMesherTest::textureCoordinates_runAroundAWholeNumberOfTimes()
{
    TreeParameters parameters = withWidths(2.2, 0.7);
    parameters.bark.scale = 0.2;
    const TreeBuilder builder = raisedTree(900, 5, parameters);
    int mostRepeats = 0;
    forEachTube(builder, [&](const MeshedTube& tube) {
        const float expected =
            std::max(1.0F, std::round(2.0F * std::numbers::pi_v<float> * tube.radii.front() / 0.2F));
        mostRepeats = std::max(mostRepeats, static_cast<int>(expected));
        float below = -1.0F;
        for (std::size_t i = 0; i < tube.rings.size(); ++i) {
            const int sides = tube.rings[i].sides;
            QCOMPARE(tube.vertex(i, 0).uv[0], 0.0F);
            QCOMPARE(tube.vertex(i, sides).uv[0], expected);
            QVERIFY(tube.vertex(i, 0).position == tube.vertex(i, sides).position);
            QVERIFY(tube.vertex(i, 0).normal == tube.vertex(i, sides).normal);
            const float v = tube.vertex(i, 0).uv[1];
            QVERIFY(v > below);
            below = v;
            for (int side = 0; side <= sides; ++side) {
                QVERIFY(std::abs(tube.vertex(i, side).uv[0] -
                                 expected * static_cast<float>(side) / static_cast<float>(sides)) < 1e-4F);
                QCOMPARE(tube.vertex(i, side).uv[1], v);
            }
        }
    });
    QVERIFY(mostRepeats >= 8);
}

void TubeMesherTest::texels_areSquare()
{
    // Straight and tapered, with a flare: a texel's edge along the tube is as long as around it.
    const TreeBuilder builder = fir(90, withWidths(2.2, 0.3));
    const MeshedTube trunk = meshed(builder, 0);
    const float repeats = trunk.vertex(0, trunk.rings.front().sides).uv[0];
    QVERIFY(trunk.rings.size() > 20);
    for (std::size_t i = 0; i + 1 < trunk.rings.size(); ++i) {
        const MeshVertex& lower = trunk.vertex(i, 0);
        const MeshVertex& upper = trunk.vertex(i + 1, 0);
        const float along =
            (toVec3(upper.position) - toVec3(lower.position)).norm() / (upper.uv[1] - lower.uv[1]);
        const float radius = 0.5F * (trunk.rings[i].radius + trunk.rings[i + 1].radius);
        const float around = 2.0F * std::numbers::pi_v<float> * radius / repeats;
        QVERIFY2(std::abs(along / around - 1.0F) < 0.05F, qPrintable(QString::number(along / around)));
    }
}

void TubeMesherTest::curve_passesThroughTheNodes()
{
    // Thin enough that no internode is skipped.
    const TreeBuilder builder = raisedTree(500, 6, withWidths(4.0, 0.0, 0.2));
    forEachTube(builder, [&](const MeshedTube& tube) {
        std::size_t ring = 0;
        for (const InternodeId id : tube.internodes) {
            const Vec3& node = builder.index.nodePosition(id);
            while (ring < tube.rings.size() && tube.rings[ring].centre != node)
                ++ring;
            QVERIFY(ring < tube.rings.size());
        }
        QVERIFY(tube.rings.back().centre == builder.index.nodePosition(tube.internodes.back()));
    });
}

void TubeMesherTest::curve_ofAThickTube_skipsShortInternodes()
{
    // Zigzagging internodes of 2 cm in a trunk of 30 cm: rings at each would cut through each other.
    TreeParameters parameters = withWidths(2.2, 0.3);
    parameters.growth.lateralsPerNode = 2;
    TreeBuilder builder(1, parameters);
    const InternodeId top =
        builder.growAxis(0, kTerminalSlot, continuing(), 60, continuing(0.6, 0.0, std::numbers::pi), 0.02F);
    InternodeId tip = top;
    for (int i = 0; i < 40; ++i) {
        const InternodeId next = builder.grow({.parent = tip, .rotation = continuing()});
        builder.grow({.parent = tip, .slot = 0, .rotation = branching(1.0)});
        tip = next;
    }
    const MeshedTube trunk = meshed(builder, 0);
    for (std::size_t i = 1; i < trunk.rings.size() && trunk.rings[i].centre.y() < 1.0F; ++i) {
        const TubeMesher::Ring& below = trunk.rings[i - 1];
        const TubeMesher::Ring& ring = trunk.rings[i];
        for (int side = 0; side < ring.sides; ++side) {
            const Vec3 rise =
                toVec3(trunk.vertex(i, side).position) - toVec3(trunk.vertex(i - 1, side).position);
            QVERIFY2(rise.dot(below.tangent + ring.tangent) > 0.0F, "rings cross");
        }
    }
}

void TubeMesherTest::radius_atANode_isTheWidth()
{
    const TreeBuilder builder = raisedTree(500, 7, withWidths(4.0, 0.0, 0.2));
    forEachTube(builder, [&](const MeshedTube& tube) {
        const float affected =
            std::max(3.5F * tube.radii.front(), tube.parentRadius + 2.5F * tube.radii.front());
        std::size_t internode = 0;
        for (const TubeMesher::Ring& ring : tube.rings) {
            while (internode < tube.internodes.size() && ring.path > 0.0F &&
                   ring.centre == builder.index.nodePosition(tube.internodes[internode])) {
                if (ring.path > affected)
                    QCOMPARE(ring.radius, tube.radii[internode]);
                ++internode;
            }
            // Between nodes the radius lies between those of the nodes.
            if (ring.path > affected && internode > 0 && internode < tube.radii.size()) {
                QVERIFY(ring.radius <= tube.radii[internode - 1] + 1e-7F);
                QVERIFY(ring.radius >= tube.radii[internode] - 1e-7F);
            }
        }
        QCOMPARE(internode, tube.internodes.size());
    });
}

void TubeMesherTest::frames_ofAPlaneCurve_keepTheirBinormal()
{
    // An arc in the plane z = 0 of 30 · 6° = 180°.
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(0.0, 0.0, 0.0), 30, continuing(radians(6), 0.0, 0.0));
    const MeshedTube tube = meshed(builder, 0);
    QVERIFY(tube.rings.back().tangent.y() < -0.9F);
    const Vec3 first = (toVec3(tube.vertex(0, 0).position) - tube.rings[0].centre) / tube.rings[0].radius;
    for (std::size_t i = 0; i < tube.rings.size(); ++i) {
        QVERIFY(std::abs(tube.rings[i].centre.z()) < 1e-5F);
        const Vec3 spoke = (toVec3(tube.vertex(i, 0).position) - tube.rings[i].centre) / tube.rings[i].radius;
        QVERIFY(std::abs(spoke.z() - first.z()) < 1e-4F);
        const Vec3 quarter =
            (toVec3(tube.vertex(i, tube.rings[i].sides / 4).position) - tube.rings[i].centre) /
            tube.rings[i].radius;
        QVERIFY(std::abs(std::abs(quarter.z()) - 1.0F) < 1e-4F);
    }
}

void TubeMesherTest::lateral_startsInsideItsParentAndThinner()
{
    for (const std::uint64_t seed : {8U, 9U}) {
        const TreeBuilder builder = raisedTree(2500, seed, withWidths(2.2, seed == 9 ? 0.5 : 0.0));
        int laterals = 0;
        forEachTube(builder, [&](const MeshedTube& tube) {
            const InternodeId base = tube.internodes.front();
            const InternodeId parent = builder.tree.parent(base);
            if (parent == kNoInternode)
                return;
            ++laterals;
            const Vec3& node = builder.index.nodePosition(parent);
            const std::size_t first = tube.rings.front().path < 0.0F ? 1 : 0; // a root below the node
            QVERIFY(tube.rings[first].centre == node);
            QVERIFY(tube.rings[first].radius <= 0.9F * tube.parentRadius * (1.0F + 1e-6F));
            // All points before the node lie within the ball of the parent's radius around it.
            for (std::size_t i = 0; i <= first; ++i) {
                for (int side = 0; side < tube.rings[i].sides; ++side)
                    QVERIFY((toVec3(tube.vertex(i, side).position) - node).norm() <= tube.parentRadius);
            }
            const float straight = builder.index.heading(parent).dot(builder.index.heading(base));
            if (straight > 0.0F && tube.parentRadius * 3.0F < builder.tree.length(parent))
                QVERIFY(tube.rings[first].tangent.dot(builder.index.heading(parent)) > 0.99F);
        });
        QVERIFY(laterals > 100);
    }
}

void TubeMesherTest::trunk_widensTowardTheGround()
{
    const TreeBuilder builder = fir(60, withWidths(2.2, 0.2));
    const MeshedTube trunk = meshed(builder, 0);
    const float radius = trunk.radii.front();
    QCOMPARE(trunk.rings.front().centre, Vec3(Vec3::Zero()));
    QVERIFY(std::abs(trunk.rings.front().radius - 1.5F * radius) < 1e-6F);
    int inFlare = 0;
    for (std::size_t i = 1; i < trunk.rings.size(); ++i) {
        QVERIFY(trunk.rings[i].radius <= trunk.rings[i - 1].radius);
        inFlare += trunk.rings[i].path < 3.5F * radius ? 1 : 0;
    }
    QVERIFY(inFlare >= 2);
}

void TubeMesherTest::sides_followTheThickness()
{
    const TreeBuilder builder = raisedTree(2500, 10, withWidths(2.2, 0.6));
    int most = 0;
    int least = 99;
    forEachTube(builder, [&](const MeshedTube& tube) {
        int below = tube.rings.front().sides;
        for (const TubeMesher::Ring& ring : tube.rings) {
            QVERIFY(std::ranges::count(kSideCounts, ring.sides) == 1);
            QVERIFY(ring.sides == below || 2 * ring.sides == below);
            below = ring.sides;
        }
        if (tube.radii.front() <= builder.tree.parameters().widths.tipDiameter)
            QVERIFY(tube.rings.front().sides <= 6);
        most = std::max(most, tube.rings.front().sides);
        least = std::min(least, tube.rings.back().sides);
    });
    QVERIFY(most >= 32);
    QCOMPARE(least, 4);
}

void TubeMesherTest::sides_keepEveryChordWithinTheTolerance()
{
    // Widths set by hand let a branch be thicker above than at its base.
    TreeBuilder builder = raisedTree(800, 14, withWidths(2.2, 0.3));
    builder.apply(widthChange(builder.tree, 40, 0.25F));
    builder.apply(widthChange(builder.tree, 200, 0.1F));
    for (const double tolerance : {0.02, 0.004, 0.001, 0.0004}) {
        std::size_t coarse = 0;
        for (const InternodeId base : tubesOf(builder.tree, builder.index)) {
            for (const TubeMesher::Ring& ring : meshed(builder, base, {.tolerance = tolerance}).rings) {
                const double depth = ring.radius * (1.0 - std::cos(std::numbers::pi / ring.sides));
                QVERIFY2(ring.sides == kSideCounts.back() || depth <= tolerance * (1.0 + 1e-5),
                         qPrintable(QStringLiteral("%1 sides at %2 m").arg(ring.sides).arg(ring.radius)));
                coarse += ring.sides == 4 ? 1 : 0;
            }
        }
        QVERIFY(coarse > 0 || tolerance <= 0.001); // not more sides than needed
    }
}

void TubeMesherTest::trunkWithoutTwigs_isRound()
{
    // Once as thick as a palm's trunk, and once as thick as its tip.
    TreeParameters parameters;
    parameters.widths.tipDiameter = 0.2;
    TreeBuilder builder(1, parameters);
    builder.growAxis(0, kTerminalSlot, continuing(), 20, continuing());
    for (const TubeMesher::Ring& ring : meshed(builder, 0).rings)
        QVERIFY(ring.sides >= 16);
}

void TubeMesherTest::coarserTolerance_thinsTheMesh()
{
    const TreeBuilder builder = fir(200, withWidths(2.2, 0.4));
    const std::size_t fine = meshed(builder, 0).vertices.size();
    const std::size_t coarse = meshed(builder, 0, {.tolerance = 0.004}).vertices.size();
    const std::size_t coarsest = meshed(builder, 0, {.tolerance = 0.1}).vertices.size();
    QVERIFY(coarse < fine * 3 / 4);
    QVERIFY(coarsest < coarse);
}

void TubeMesherTest::internodesOfNoLength_areMeshed()
{
    for (const float length : {0.0F, 1e-40F, 1e-30F, 1e-12F, 1e-4F}) {
        TreeBuilder builder(1, withWidths(2.2, 0.4));
        const InternodeId top = builder.growAxis(0, kTerminalSlot, continuing(), 40, continuing(), length);
        builder.growAxis(top, kTerminalSlot, continuing(), 3, continuing());
        builder.growAxis(top, 0, branching(1.0), 5, continuing(), length);
        forEachTube(builder, [&](const MeshedTube& tube) {
            for (const MeshVertex& vertex : tube.vertices) {
                QVERIFY(toVec3(vertex.position).allFinite());
                QVERIFY(toVec3(vertex.normal).allFinite());
                QVERIFY(std::isfinite(vertex.uv[1]));
            }
        });
    }
}

void TubeMesherTest::nothing_liesBelowTheGround()
{
    // A trunk that leans, one that lies, and a branch that bows into the ground and out of it again.
    for (const double lean : {0.0, 0.4, 1.2, 1.6}) {
        TreeParameters parameters = withWidths(2.2, 0.3);
        TreeBuilder builder(1, parameters);
        builder.apply(bend(builder.tree, 0, continuing(lean, 0.0, 0.0), 1.0F));
        const InternodeId top =
            builder.growAxis(0, kTerminalSlot, continuing(0.0, 0.0, 0.0), 5, continuing(0.0, 0.0, 0.0));
        builder.growAxis(top, 0, branching(2.6 - lean), 30, continuing(-0.1, 0.0, 0.0));
        bool dips = false;
        forEachTube(builder, [&](const MeshedTube& tube) {
            for (const MeshVertex& vertex : tube.vertices)
                QVERIFY2(vertex.position[1] >= 0.0F, qPrintable(QString::number(vertex.position[1])));
            for (const TubeMesher::Ring& ring : tube.rings)
                dips |= ring.centre.y() < ring.radius;
        });
        QVERIFY(dips);
        // The foot of a trunk that stands lies on the ground all around.
        const MeshedTube trunk = meshed(builder, 0);
        if (lean < 1.5) {
            for (int side = 0; side < trunk.rings.front().sides; ++side)
                QVERIFY(trunk.vertex(0, side).position[1] < 1e-6F);
        }
    }
}

void TubeMesherTest::origins_nameTheInternodeOfEachVertex()
{
    const TreeBuilder builder = raisedTree(900, 15, withWidths(2.2, 0.3));
    const Widths widths(builder.tree, builder.index);
    const BranchMesh mesh = meshBranches(builder.tree, builder.index, widths);
    QCOMPARE(mesh.origins.size(), mesh.vertices.size());
    std::vector<int> seen(builder.tree.size(), 0);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto& [id, along] = mesh.origins[i];
        QVERIFY(builder.tree.isAlive(id) && along >= 0.0F && along <= 1.0F);
        ++seen[id];
        // The distance of the vertex from that place is limited: the radius, a collar, and the deviation of a
        // curve.
        const Vec3 place = builder.index.basePosition(builder.tree, id) +
                           along * builder.tree.length(id) * builder.index.heading(id);
        const float reach = 2.0F * widths.radius(builder.index, id) + builder.tree.length(id);
        QVERIFY((toVec3(mesh.vertices[i].position) - place).norm() < reach);
    }
    // All nodes, except those that a thick branch skips.
    QVERIFY(std::ranges::count(seen, 0) * 10 < static_cast<std::ptrdiff_t>(seen.size()));
}

const TestClass<TubeMesherTest> tubeMesherTest;

} // namespace espalier::test

#include "TubeMesherTest.moc"

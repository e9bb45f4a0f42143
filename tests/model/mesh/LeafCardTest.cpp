// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/LeafCard.h"

#include "model/mesh/LeafPlacer.h"
#include "tests/support/Leaves.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <tbb/global_control.h>

namespace espalier::test {

class LeafCardTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cards_areSmallAndWhole();
    void folds_riseAtTheEdges();
    void expansion_putsTheCardInPlace();
    void expansion_leavesHiddenLeavesOut();
    void roundness_turnsNormalsOutOfTheCrown();
    void expansion_isTheSameOnOneThreadAndMany();
};

namespace {

constexpr std::array kShapes{
    LeafShape::Ovate,   LeafShape::Lanceolate, LeafShape::Lobed,  LeafShape::Needles,  LeafShape::Cordate,
    LeafShape::Palmate, LeafShape::Pinnate,    LeafShape::Willow, LeafShape::Fascicle, LeafShape::Frond};

LeafInstance leafAt(const Vec3& position, LeafShape shape = LeafShape::Ovate)
{
    return {.position = toArray(position),
            .length = 0.1F,
            .rotation = {0.0F, 0.0F, 0.0F, 1.0F},
            .width = 0.05F,
            .hueShift = 0.0F,
            .value = 1.0F,
            .shape = static_cast<std::int32_t>(shape)};
}

} // namespace

void LeafCardTest::cards_areSmallAndWhole()
{
    for (const LeafShape shape : kShapes) {
        const LeafCard& card = leafCard(shape);
        QVERIFY(card.indices.size() <= (shape == LeafShape::Frond ? 60U : 24U));
        for (const MeshVertex& vertex : card.vertices) {
            const Vec3 normal = toVec3(vertex.normal);
            const Vec3 tangent(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]);
            QVERIFY(std::abs(normal.norm() - 1.0F) < 1e-5F);
            QVERIFY(std::abs(tangent.norm() - 1.0F) < 1e-5F);
            QVERIFY(std::abs(normal.dot(tangent)) < 1e-5F);
            QCOMPARE(vertex.tangent[3], 1.0F);
            // v rises from petiole to tip, and so does the bitangent.
            QCOMPARE(vertex.uv[1], vertex.position[1]);
            QVERIFY(normal.cross(tangent).y() > 0.5F);
            for (const float coordinate : vertex.uv)
                QVERIFY(coordinate >= 0.0F && coordinate <= 1.0F);
        }
        for (std::size_t i = 0; i < card.indices.size(); i += 3) {
            const MeshVertex& a = card.vertices[card.indices[i]];
            const Vec3 face =
                (toVec3(card.vertices[card.indices[i + 1]].position) - toVec3(a.position))
                    .cross(toVec3(card.vertices[card.indices[i + 2]].position) - toVec3(a.position));
            QVERIFY(face.norm() > 0.01F);
            QVERIFY(face.normalized().dot(toVec3(a.normal)) > 0.5F);
        }
    }
}

void LeafCardTest::folds_riseAtTheEdges()
{
    for (const LeafShape shape : {LeafShape::Ovate, LeafShape::Lanceolate, LeafShape::Lobed}) {
        float tip = 1.0F;
        for (const MeshVertex& vertex : leafCard(shape).vertices) {
            if (vertex.position[0] < 0.0F)
                QVERIFY(vertex.normal[0] > 0.0F); // the left half faces right
            if (vertex.position[1] == 1.0F)
                tip = vertex.position[2];
        }
        QVERIFY(tip < 0.0F); // and the tip hangs
    }
}

void LeafCardTest::expansion_putsTheCardInPlace()
{
    // A quarter turn about +Z takes the midrib from +Y to −X.
    LeafInstance leaf = leafAt({1.0F, 2.0F, 3.0F});
    const Rotation turn(Eigen::AngleAxisf(std::numbers::pi_v<float> / 2.0F, Vec3::UnitZ()));
    leaf.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
    const TriangleMesh mesh = expandLeaves(std::span(&leaf, 1));
    const LeafCard& card = leafCard(LeafShape::Ovate);
    QCOMPARE(mesh.vertices.size(), card.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const std::array<float, 3>& p = card.vertices[i].position;
        const Vec3 expected(1.0F - 0.1F * p[1], 2.0F + 0.05F * p[0], 3.0F + 0.05F * p[2]);
        QVERIFY((toVec3(mesh.vertices[i].position) - expected).norm() < 1e-6F);
        QVERIFY(mesh.vertices[i].uv == card.vertices[i].uv);
        const std::array<float, 3>& n = card.vertices[i].normal;
        QVERIFY((toVec3(mesh.vertices[i].normal) - Vec3(-n[1], n[0], n[2])).norm() < 1e-6F);
    }
}

void LeafCardTest::expansion_leavesHiddenLeavesOut()
{
    std::vector<LeafInstance> leaves{leafAt({0, 0, 0}, LeafShape::Needles), leafAt({1, 0, 0}),
                                     leafAt({2, 0, 0}, LeafShape::Lobed)};
    leaves[1].length = 0.0F;
    const TriangleMesh mesh = expandLeaves(leaves);
    const LeafCard& needles = leafCard(LeafShape::Needles);
    const LeafCard& lobed = leafCard(LeafShape::Lobed);
    QCOMPARE(mesh.vertices.size(), needles.vertices.size() + lobed.vertices.size());
    QCOMPARE(mesh.indices.size(), needles.indices.size() + lobed.indices.size());
    for (std::size_t i = 0; i < lobed.indices.size(); ++i) {
        QCOMPARE(mesh.indices[needles.indices.size() + i],
                 lobed.indices[i] + static_cast<VertexIndex>(needles.vertices.size()));
    }
    QVERIFY(expandLeaves({}).vertices.empty());
}

void LeafCardTest::roundness_turnsNormalsOutOfTheCrown()
{
    const TreeBuilder builder = raisedTree(300, 1);
    const auto leaves = leavesOf(builder);
    const Vec3 centre(0.0F, 1.0F, 0.0F);
    double outwardBefore = 0.0;
    for (const double roundness : {0.0, 0.4, 0.8, 1.0}) {
        const TriangleMesh mesh = expandLeaves(leaves, {.roundness = roundness, .crownCentre = centre});
        double outward = 0.0;
        for (const MeshVertex& vertex : mesh.vertices) {
            const Vec3 normal = toVec3(vertex.normal);
            const Vec3 tangent(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]);
            QVERIFY(std::abs(normal.norm() - 1.0F) < 1e-4F);
            QVERIFY(std::abs(tangent.norm() - 1.0F) < 1e-4F);
            QVERIFY(std::abs(normal.dot(tangent)) < 1e-4F);
            outward += normal.dot((toVec3(vertex.position) - centre).normalized()) /
                       static_cast<double>(mesh.vertices.size());
        }
        QVERIFY(roundness == 0.0 || outward > outwardBefore);
        outwardBefore = outward;
    }
    QVERIFY(outwardBefore > 0.9999);
}

void LeafCardTest::expansion_isTheSameOnOneThreadAndMany()
{
    const TreeBuilder builder = raisedTree(9000, 2);
    const auto leaves = leavesOf(builder);
    QVERIFY(leaves.size() > 8192);
    TriangleMesh single;
    {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        single = expandLeaves(leaves);
    }
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    const TriangleMesh many = expandLeaves(leaves);
    QVERIFY(single.vertices == many.vertices);
    QVERIFY(single.indices == many.indices);
}

const TestClass<LeafCardTest> leafCardTest;

} // namespace espalier::test

#include "LeafCardTest.moc"

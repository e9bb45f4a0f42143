// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/SurfaceCheck.h"

#include "model/mesh/FlatTriangles.h"
#include "model/mesh/PlanarPatch.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>
#include <map>

namespace espalier::test {

namespace {

/// A box from -1 to 1, m, with its triangles facing outward.
TriangleMesh box(const Vec3& middle = Vec3::Zero())
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        MeshVertex vertex{};
        vertex.position = toArray(Vec3(middle + Vec3((i & 1) != 0 ? 1.0F : -1.0F, (i & 2) != 0 ? 1.0F : -1.0F,
                                                     (i & 4) != 0 ? 1.0F : -1.0F)));
        mesh.vertices.push_back(vertex);
    }
    for (const VertexIndex index : {0U, 2U, 1U, 1U, 2U, 3U, 4U, 5U, 6U, 5U, 7U, 6U, 0U, 1U, 4U, 1U, 5U, 4U,
                                    2U, 6U, 3U, 3U, 6U, 7U, 0U, 4U, 2U, 2U, 4U, 6U, 1U, 3U, 5U, 3U, 7U, 5U})
        mesh.indices.push_back(index);
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other)
{
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const VertexIndex index : other.indices)
        mesh.indices.push_back(first + index);
}

PlanarPatch::Outline circle(const Vec2& centre, float radius, int count, bool withStrands = false)
{
    PlanarPatch::Outline outline;
    for (int i = 0; i < count; ++i) {
        const float angle =
            2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(count);
        outline.points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
        if (withStrands)
            outline.strands.push_back(static_cast<std::uint32_t>(i));
    }
    return outline;
}

/// How often each directed edge of the triangles occurs without its opposite.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> rimOf(const PlanarPatch::Triangles& triangles)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& corners : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{corners[k], corners[(k + 1) % 3]}];
            --edges[{corners[(k + 1) % 3], corners[k]}];
        }
    }
    std::erase_if(edges, [](const auto& edge) { return edge.second <= 0; });
    return edges;
}

} // namespace

/// The check of surfaces, and the patches that close them at forks.
class SurfaceCheckTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void box_isClosed();
    void faults_areFound_data();
    void faults_areFound();
    void flatTriangles_getAnArea_data();
    void flatTriangles_getAnArea();
    void crossingBoxes_areCounted();
    void patch_joinsOutlinesOfTheSameStrands();
    void patch_hasEachOutlineEdgeOnce_data();
    void patch_hasEachOutlineEdgeOnce();
};

void SurfaceCheckTest::box_isClosed()
{
    const SurfaceFaults faults = checkSurface(box(), true);
    QVERIFY(faults.isClosed());
    QCOMPARE(faults.components, 1U);
    QCOMPARE(faults.selfIntersections, 0U);
    QVERIFY(std::abs(enclosedVolume(box()) - 8.0) < 1e-6);
}

void SurfaceCheckTest::flatTriangles_getAnArea_data()
{
    // Directions of the edge beside the flat triangle.
    QTest::addColumn<Vec3>("edge");
    for (const Vec3& edge : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(-1, 1, 0),
                             Vec3(1, 1, 1), Vec3(1, -2, 3), Vec3(0, -1, 1), Vec3(-3, 1, 1)})
        QTest::addRow("%g %g %g", double{edge.x()}, double{edge.y()}, double{edge.z()}) << edge;
}

void SurfaceCheckTest::flatTriangles_getAnArea()
{
    QFETCH(Vec3, edge);
    // A vertex in the middle of the edge from 0 to 1, with a triangle of no area beside that edge.
    TriangleMesh mesh = box();
    MeshVertex middle{};
    middle.position = {0.0F, -1.0F, -1.0F};
    mesh.vertices.push_back(middle);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        if (mesh.indices[i] == 0 && mesh.indices[i + 1] == 2 && mesh.indices[i + 2] == 1) {
            mesh.indices[i + 2] = 8;
            break;
        }
    }
    for (const VertexIndex index : {8U, 2U, 1U, 0U, 8U, 1U})
        mesh.indices.push_back(index);
    // Whole numbers keep it exactly flat.
    Eigen::Matrix3f shear = Eigen::Matrix3f::Identity();
    Eigen::Index along = 0;
    edge.cwiseAbs().maxCoeff(&along);
    shear.col(1) = Vec3::Unit((along + 1) % 3);
    shear.col(2) = Vec3::Unit((along + 2) % 3);
    shear.col(0) = edge;
    if (shear.determinant() < 0.0F)
        shear.col(1) = -shear.col(1);
    for (MeshVertex& vertex : mesh.vertices)
        vertex.position = toArray(Vec3(shear * toVec3(vertex.position)));
    QCOMPARE(checkSurface(mesh).degenerate, 1U);
    QCOMPARE(checkSurface(mesh).openEdges, 0U);
    const TriangleMesh before = mesh;
    raiseFlatTriangles(mesh.indices, mesh.vertices);
    QVERIFY(checkSurface(mesh).isClosed());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        QVERIFY((toVec3(mesh.vertices[i].position) - toVec3(before.vertices[i].position)).norm() < 1e-3F);
    const TriangleMesh raised = mesh;
    raiseFlatTriangles(mesh.indices, mesh.vertices);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        QCOMPARE(mesh.vertices[i].position, raised.vertices[i].position);
}

void SurfaceCheckTest::faults_areFound_data()
{
    QTest::addColumn<QByteArray>("fault");
    for (const char* name :
         {"hole", "three at an edge", "inside out", "flat", "touching at a corner", "turned triangle"})
        QTest::newRow(name) << QByteArray(name);
}

void SurfaceCheckTest::faults_areFound()
{
    QFETCH(QByteArray, fault);
    TriangleMesh mesh = box();
    if (fault == "hole") {
        mesh.indices.resize(mesh.indices.size() - 3);
        QCOMPARE(checkSurface(mesh).openEdges, 3U);
    } else if (fault == "three at an edge") {
        for (const VertexIndex index : {0U, 1U, 7U})
            mesh.indices.push_back(index);
        QVERIFY(checkSurface(mesh).nonManifoldEdges >= 1);
    } else if (fault == "inside out") {
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i], mesh.indices[i + 1]);
        QCOMPARE(checkSurface(mesh).inverted, 1U);
    } else if (fault == "flat") {
        for (const VertexIndex index : {0U, 1U, 1U})
            mesh.indices.push_back(index);
        QCOMPARE(checkSurface(mesh).degenerate, 1U);
    } else if (fault == "touching at a corner") {
        append(mesh, box(Vec3(2.0F, 2.0F, 2.0F)));
        QCOMPARE(checkSurface(mesh).nonManifoldVertices, 1U);
    } else {
        std::swap(mesh.indices[0], mesh.indices[1]);
        QCOMPARE(checkSurface(mesh).nonManifoldEdges, 3U);
    }
}

void SurfaceCheckTest::crossingBoxes_areCounted()
{
    TriangleMesh mesh = box();
    append(mesh, box(Vec3(0.9F, 0.8F, 0.7F)));
    const SurfaceFaults faults = checkSurface(mesh, true);
    QVERIFY(faults.isClosed());
    QCOMPARE(faults.components, 2U);
    QVERIFY(faults.selfIntersections >= 6);
}

void SurfaceCheckTest::patch_joinsOutlinesOfTheSameStrands()
{
    PlanarPatch patch;
    PlanarPatch::Triangles triangles;
    const std::array whole{circle(Vec2::Zero(), 2.0F, 12, true)};
    const std::array parts{circle(Vec2::Zero(), 1.0F, 12, true)};
    patch.triangulate(whole, parts, triangles);
    QCOMPARE(triangles.size(), std::size_t{24});
}

void SurfaceCheckTest::patch_hasEachOutlineEdgeOnce_data()
{
    QTest::addColumn<int>("parts");
    QTest::addColumn<bool>("cross");
    for (int parts = 0; parts < 7; ++parts) {
        QTest::addRow("%d parts", parts) << parts << false;
        QTest::addRow("%d parts that cross", parts) << parts << true;
    }
}

void SurfaceCheckTest::patch_hasEachOutlineEdgeOnce()
{
    QFETCH(int, parts);
    QFETCH(bool, cross);
    PlanarPatch patch;
    PlanarPatch::Triangles triangles;
    const std::array whole{circle(Vec2::Zero(), 10.0F, 17)};
    std::vector<PlanarPatch::Outline> inner;
    for (int i = 0; i < parts; ++i) {
        const float angle = static_cast<float>(i);
        inner.push_back(circle(6.0F * Vec2(std::cos(angle), std::sin(angle)), cross ? 5.0F : 2.0F, 5 + i));
    }
    patch.triangulate(whole, inner, triangles);
    const auto rim = rimOf(triangles);
    std::uint32_t first = 0;
    const auto verifyOutline = [&](const PlanarPatch::Outline& outline, bool isWhole) {
        const auto count = static_cast<std::uint32_t>(outline.points.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t a = first + i;
            const std::uint32_t b = first + (i + 1) % count;
            QVERIFY(rim.contains(isWhole ? std::pair(a, b) : std::pair(b, a)));
        }
        first += count;
    };
    verifyOutline(whole.front(), true);
    for (const PlanarPatch::Outline& outline : inner)
        verifyOutline(outline, false);
    QCOMPARE(rim.size(), std::size_t{first});
}

const TestClass<SurfaceCheckTest> surfaceCheckTest;

} // namespace espalier::test

#include "SurfaceCheckTest.moc"

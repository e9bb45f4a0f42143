// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FbxGeometry.h"

#include "model/io/export/FbxRepair.h"
#include "tests/support/TestClasses.h"

#include <QBuffer>
#include <QTest>

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>

#include <memory>
#include <random>

namespace espalier::test {

namespace {

/// Triangles with many vertices at one place and with equal texture coordinates, some of which no triangle
/// uses.
TriangleMesh randomMesh(std::uint32_t seed, std::uint32_t vertices, std::size_t triangles)
{
    std::mt19937 random(seed);
    const auto coarse = [&random] { return 0.25F * static_cast<float>(random() % 9) - 1.0F; };
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < vertices; ++i) {
        MeshVertex vertex{};
        vertex.position = {coarse(), coarse(), i % 7 == 0 ? -0.0F : coarse()};
        vertex.normal = {coarse(), coarse(), coarse()};
        vertex.uv = {coarse(), coarse()};
        mesh.vertices.push_back(vertex);
    }
    for (std::size_t i = 0; i < triangles; ++i) {
        // Assimp leaves out triangles that are lines.
        const std::uint32_t first = random() % (vertices - 2);
        for (const std::uint32_t index : {first, first + 1, first + 2})
            mesh.indices.push_back(index);
    }
    return mesh;
}

/// An FBX file with these triangles, as Assimp writes it alone.
QByteArray byAssimp(const TriangleMesh& source)
{
    auto scene = std::make_unique<aiScene>();
    auto* const mesh = new aiMesh;
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    const auto vertices = static_cast<unsigned>(source.vertices.size());
    mesh->mNumVertices = vertices;
    mesh->mVertices = new aiVector3D[vertices];
    mesh->mNormals = new aiVector3D[vertices];
    mesh->mTextureCoords[0] = new aiVector3D[vertices];
    mesh->mNumUVComponents[0] = 2;
    for (unsigned i = 0; i < vertices; ++i) {
        const MeshVertex& vertex = source.vertices[i];
        mesh->mVertices[i] = {vertex.position[0], vertex.position[1], vertex.position[2]};
        mesh->mNormals[i] = {vertex.normal[0], vertex.normal[1], vertex.normal[2]};
        mesh->mTextureCoords[0][i] = {vertex.uv[0], vertex.uv[1], 0.0F};
    }
    mesh->mNumFaces = static_cast<unsigned>(source.indices.size() / 3);
    mesh->mFaces = new aiFace[mesh->mNumFaces];
    for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
        mesh->mFaces[i].mNumIndices = 3;
        mesh->mFaces[i].mIndices =
            new unsigned[3]{source.indices[3 * i], source.indices[3 * i + 1], source.indices[3 * i + 2]};
    }
    scene->mNumMeshes = scene->mNumMaterials = 1;
    scene->mMeshes = new aiMesh* [1] { mesh };
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene->mRootNode = new aiNode("Tree");
    scene->mRootNode->mNumMeshes = 1;
    scene->mRootNode->mMeshes = new unsigned[1]{0};
    Assimp::Exporter exporter;
    const aiExportDataBlob* const blob = exporter.ExportToBlob(scene.get(), "fbx");
    return blob == nullptr
               ? QByteArray()
               : QByteArray(static_cast<const char*>(blob->data), static_cast<qsizetype>(blob->size));
}

QByteArray bytesOf(const FbxDocument& document)
{
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    return writeFbx(document, bytes) ? bytes.data() : QByteArray();
}

FbxNode* geometryOf(FbxDocument& document)
{
    for (FbxNode& node : document.nodes) {
        if (FbxNode* geometry = node.name == "Objects" ? node.child("Geometry") : nullptr)
            return geometry;
    }
    return nullptr;
}

} // namespace

class FbxGeometryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void triangles_areThoseThatAssimpWrites_data();
    void triangles_areThoseThatAssimpWrites();
    void objectWithoutItsArrays_isRefused();
};

void FbxGeometryTest::triangles_areThoseThatAssimpWrites_data()
{
    QTest::addColumn<int>("vertices");
    QTest::addColumn<int>("triangles");
    QTest::newRow("one") << 3 << 1;
    QTest::newRow("some") << 50 << 30;
    QTest::newRow("more than a block") << 4'000 << 9'000;
}

void FbxGeometryTest::triangles_areThoseThatAssimpWrites()
{
    QFETCH(const int, vertices);
    QFETCH(const int, triangles);
    const TriangleMesh mesh =
        randomMesh(5, static_cast<std::uint32_t>(vertices), static_cast<std::size_t>(triangles));
    const QByteArray whole = byAssimp(mesh);
    const Result<FbxDocument> expected = repairFbx(whole);
    QVERIFY(expected);

    const QByteArray small = byAssimp(randomMesh(1, 3, 1));
    Result<FbxDocument> document = repairFbx(small);
    QVERIFY(document);
    FbxNode* const geometry = geometryOf(*document);
    QVERIFY(geometry);
    QVERIFY(setFbxTriangles(*geometry, mesh));
    QVERIFY(bytesOf(*document) == bytesOf(*expected));
}

void FbxGeometryTest::objectWithoutItsArrays_isRefused()
{
    const TriangleMesh mesh = randomMesh(5, 50, 30);
    const QByteArray small = byAssimp(mesh);
    for (const char* name : {"Vertices", "PolygonVertexIndex", "LayerElementNormal", "LayerElementUV"}) {
        Result<FbxDocument> document = repairFbx(small);
        FbxNode* const geometry = geometryOf(*document);
        geometry->child(name)->name = "Other";
        QVERIFY2(!setFbxTriangles(*geometry, mesh), name);
    }
}

static const TestClass<FbxGeometryTest> fbxGeometryTest;

} // namespace espalier::test

#include "FbxGeometryTest.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/Exporter.h"

#include "model/io/export/FbxNodes.h"
#include "model/io/export/FbxRepair.h"
#include "model/mesh/LeafCard.h"
#include "model/mesh/LeafPlacer.h"
#include "model/shape/Widths.h"
#include "tests/support/Leaves.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>
#include <qfloat16.h>

#include <assimp/GltfMaterial.h>
#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>

namespace espalier::test {

namespace {

/// Small textures, because these tests do not look at their content.
constexpr ExportOptions kSmall{.textureSize = 64};

TreeBuilder sampleTree(std::uint32_t count = 120)
{
    TreeParameters parameters;
    parameters.growth.lateralsPerNode = 2;
    return randomTree(count, 3, parameters);
}

QByteArray contentOf(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList filesIn(const QTemporaryDir& folder)
{
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

Box3 boundsOf(const TriangleMesh& mesh)
{
    Box3 box;
    for (const MeshVertex& vertex : mesh.vertices)
        box.extend(toVec3(vertex.position));
    return box;
}

} // namespace

class ExporterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void scene_hasOneMeshAndMaterialEachForBarkAndLeaves();
    void scene_withoutLeavesHasBarkAlone();
    void leavesOfOneHue_takeOneTile();
    void leavesOfManyHues_lieInTheTileOfTheirHue();
    void imagesOfOnesOwn_takeThePlaceOfTheDrawnOnes();
    void names_becomeSafe();
    void obj_hasEveryVertexAndRefersToFilesThatExist();
    void glb_hasNamesMaterialsAndTexturesInside();
    void fbx_isSoundAndCountsInMetres();
    void fbx_hasNoTimeOfItsOwn();
    void fbx_namesItsTexturesImagesAndGeometries();
    void fbx_hasTheGlossOfTheRoughness();
    void fbx_takesTransparencyFromTheMask();
    void mask_hasTheColoursAlphaInAllChannels();
    void barkOfALongAxis_keepsItsCoordinatesAsHalfFloats();
    void roughnessAsANumber_isTheMeanOfTheTexture();
    void csv_hasARowForEachLivingInternode();
    void sameTree_givesTheSameBytes();
    void exports_replaceEarlierOnes();
    void formats_areFoundByTheirEnding();
    void unknownEnding_isRefused();
    void folderThatIsMissing_isAnError();
    void cancelling_leavesWhatWasThere_data();
    void cancelling_leavesWhatWasThere();
    void progress_ascendsToOne();
};

void ExporterTest::scene_hasOneMeshAndMaterialEachForBarkAndLeaves()
{
    const TreeBuilder builder = sampleTree();
    const ExportScene scene = buildExportScene(builder.tree, builder.index, QStringLiteral("Oak"), kSmall);
    QCOMPARE(scene.meshes.size(), 2U);
    QCOMPARE(scene.meshes[0].name, QStringLiteral("Oak_Bark_LOD0"));
    QCOMPARE(scene.meshes[1].name, QStringLiteral("Oak_Leaves_LOD0"));
    QCOMPARE(scene.materials[scene.meshes[0].material].name, QStringLiteral("Oak_Bark"));
    QCOMPARE(scene.materials[scene.meshes[1].material].name, QStringLiteral("Oak_Leaves"));
    for (const ExportMesh& mesh : scene.meshes) {
        QVERIFY(mesh.mesh.indices.size() > 300);
        QVERIFY(std::ranges::max(mesh.mesh.indices) < mesh.mesh.vertices.size());
    }
    const QImage bark = QImage::fromData(scene.materials[0].colour.png, "png");
    QCOMPARE(bark.size(), QSize(64, 64));
    QVERIFY(!bark.hasAlphaChannel()); // or some readers make the bark transparent
    QVERIFY(!QImage::fromData(scene.materials[0].normal.png, "png").hasAlphaChannel());
    const QImage leaf = QImage::fromData(scene.materials[1].colour.png, "png");
    QVERIFY(leaf.hasAlphaChannel());
    QCOMPARE(leaf.height(), 32);
    QCOMPARE(QImage::fromData(scene.materials[1].normal.png, "png").size(), leaf.size());
    QCOMPARE(QImage::fromData(scene.materials[1].roughness.png, "png").size(), leaf.size());
    QVERIFY(QImage::fromData(scene.materials[0].roughness.png, "png").isGrayscale());
}

void ExporterTest::scene_withoutLeavesHasBarkAlone()
{
    TreeBuilder builder = sampleTree();
    ExportOptions options = kSmall;
    options.leaves = false;
    QCOMPARE(buildExportScene(builder.tree, builder.index, {}, options).meshes.size(), 1U);
    TreeParameters parameters = builder.tree.parameters();
    parameters.leaves.visible = false;
    builder.apply(parameterChange(builder.tree, parameters));
    const ExportScene scene = buildExportScene(builder.tree, builder.index, {}, kSmall);
    QCOMPARE(scene.meshes.size(), 1U);
    QCOMPARE(scene.materials.size(), 1U);
}

void ExporterTest::leavesOfOneHue_takeOneTile()
{
    TreeBuilder builder = sampleTree();
    TreeParameters parameters = builder.tree.parameters();
    parameters.leaves.hueVariation = 0.0;
    parameters.leaves.vigourHue = 0.0;
    builder.apply(parameterChange(builder.tree, parameters));
    const ExportScene scene = buildExportScene(builder.tree, builder.index, {}, kSmall);
    const QImage leaf = QImage::fromData(scene.materials[1].colour.png, "png");
    QCOMPARE(leaf.size(), QSize(32, 32));
    const MeshBuffer<LeafInstance> leaves = leavesOf(builder);
    const TriangleMesh plain = expandLeaves(leaves);
    QVERIFY(scene.meshes[1].mesh.vertices == plain.vertices);
}

void ExporterTest::leavesOfManyHues_lieInTheTileOfTheirHue()
{
    TreeBuilder builder = sampleTree(300);
    TreeParameters parameters = builder.tree.parameters();
    parameters.leaves.vigourHue = 1.0;
    builder.apply(parameterChange(builder.tree, parameters));
    const ExportScene scene = buildExportScene(builder.tree, builder.index, {}, kSmall);
    const QImage leaf = QImage::fromData(scene.materials[1].colour.png, "png");
    QCOMPARE(leaf.size(), QSize(8 * 32, 32));

    const MeshBuffer<LeafInstance> leaves = leavesOf(builder);
    const std::size_t perLeaf = leafCard(parameters.leaves.shape).vertices.size();
    const auto& vertices = scene.meshes[1].mesh.vertices;
    QCOMPARE(vertices.size(), leaves.size() * perLeaf);
    std::array<float, 8> least{};
    std::array<float, 8> greatest{};
    least.fill(10.0F);
    greatest.fill(-10.0F);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        float from = 1.0F;
        float to = 0.0F;
        for (std::size_t v = i * perLeaf; v < (i + 1) * perLeaf; ++v) {
            from = std::min(from, vertices[v].uv[0]);
            to = std::max(to, vertices[v].uv[0]);
        }
        const auto tile = static_cast<std::size_t>((from + to) / 2 * 8);
        QVERIFY(from >= static_cast<float>(tile) / 8 - 1e-6F);
        QVERIFY(to <= static_cast<float>(tile + 1) / 8 + 1e-6F);
        least[tile] = std::min(least[tile], leaves[i].hueShift);
        greatest[tile] = std::max(greatest[tile], leaves[i].hueShift);
    }
    for (std::size_t tile = 1; tile < 8; ++tile)
        QVERIFY(greatest[tile - 1] <= least[tile]);

    // The first tile is the reddest, the last the greenest.
    const auto hueOfTile = [&](int tile) {
        int red = 0;
        int green = 0;
        for (int y = 0; y < leaf.height(); ++y) {
            for (int x = 32 * tile; x < 32 * (tile + 1); ++x) {
                const QColor colour = leaf.pixelColor(x, y);
                if (colour.alpha() > 200) {
                    red += colour.red();
                    green += colour.green();
                }
            }
        }
        return double(green) / red;
    };
    QVERIFY(hueOfTile(0) < 0.9);
    QVERIFY(hueOfTile(7) > 1.1);
}

void ExporterTest::imagesOfOnesOwn_takeThePlaceOfTheDrawnOnes()
{
    TreeBuilder builder = sampleTree();
    TreeParameters parameters = builder.tree.parameters();
    parameters.leaves.image = ImageAsset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("leaf.png"));
    parameters.leaves.hueVariation = 0.0;
    parameters.leaves.vigourHue = 0.0;
    parameters.bark.image = ImageAsset(pngOf(repeatingBark(64, 64)), QStringLiteral("bark.png"));
    builder.apply(parameterChange(builder.tree, parameters));
    const ExportScene scene =
        buildExportScene(builder.tree, builder.index, {}, ExportOptions{.textureSize = 512});
    QCOMPARE(scene.materials.size(), 2U);
    QCOMPARE(QImage::fromData(scene.materials[0].colour.png, "png").convertToFormat(QImage::Format_RGB888),
             repeatingBark(64, 64).convertToFormat(QImage::Format_RGB888));
    const QImage leaf = QImage::fromData(scene.materials[1].colour.png, "png");
    QVERIFY(std::abs(leaf.width() - 80) <= 3 && std::abs(leaf.height() - 160) <= 3);
    // The texture has the image's own colours.
    const QColor middle = leaf.pixelColor(leaf.width() / 2, leaf.height() / 2);
    QVERIFY2(std::abs(middle.red() - 70) < 6 && std::abs(middle.green() - 150) < 6 &&
                 std::abs(middle.blue() - 40) < 6,
             qPrintable(middle.name()));
    QCOMPARE(qAlpha(leaf.pixel(0, 0)), 0);
    for (const ExportTexture* texture : {&scene.materials[1].normal, &scene.materials[1].roughness})
        QCOMPARE(QImage::fromData(texture->png, "png").size(), leaf.size());
    const std::size_t perLeaf = leafCard(LeafShape::Own).vertices.size();
    QCOMPARE(scene.meshes[1].mesh.vertices.size(), leavesOf(builder).size() * perLeaf);
}

void ExporterTest::names_becomeSafe()
{
    QCOMPARE(safeExportName(QStringLiteral("Oak")), QStringLiteral("Oak"));
    QCOMPARE(safeExportName(QStringLiteral("  Old oak #2/b ")), QStringLiteral("Old_oak__2_b"));
    QCOMPARE(safeExportName(QStringLiteral("Bäume-1")), QStringLiteral("Bäume-1"));
    QCOMPARE(safeExportName(QString()), QStringLiteral("Tree"));
}

void ExporterTest::obj_hasEveryVertexAndRefersToFilesThatExist()
{
    const QTemporaryDir folder;
    const TreeBuilder builder = sampleTree();
    QVERIFY(exportTree(builder.tree, builder.index, QStringLiteral("Oak"),
                       folder.filePath(QStringLiteral("my oak.obj")), kSmall));
    QCOMPARE(filesIn(folder),
             (QStringList{QStringLiteral("my oak.obj"), QStringLiteral("my_oak.mtl"),
                          QStringLiteral("my_oak_bark.png"), QStringLiteral("my_oak_bark_normal.png"),
                          QStringLiteral("my_oak_bark_roughness.png"), QStringLiteral("my_oak_leaf.png"),
                          QStringLiteral("my_oak_leaf_mask.png"), QStringLiteral("my_oak_leaf_normal.png"),
                          QStringLiteral("my_oak_leaf_roughness.png")}));

    const ExportScene scene = buildExportScene(builder.tree, builder.index, QStringLiteral("Oak"), kSmall);
    std::vector<MeshVertex> vertices;
    std::vector<std::size_t> corners;
    for (const ExportMesh& mesh : scene.meshes) {
        for (const VertexIndex index : mesh.mesh.indices)
            corners.push_back(vertices.size() + index + 1);
        vertices.insert(vertices.end(), mesh.mesh.vertices.begin(), mesh.mesh.vertices.end());
    }
    std::vector<Vec3> positions;
    std::size_t coordinates = 0;
    std::size_t normals = 0;
    std::size_t corner = 0;
    QByteArrayList objects;
    for (const QByteArray& line : contentOf(folder.filePath(QStringLiteral("my oak.obj"))).split('\n')) {
        const QByteArrayList words = line.split(' ');
        if (words[0] == "v") {
            positions.emplace_back(words[1].toFloat(), words[2].toFloat(), words[3].toFloat());
        } else if (words[0] == "vt") {
            const auto& uv = vertices[coordinates++].uv;
            QVERIFY(words[1].toFloat() == uv[0] && words[2].toFloat() == uv[1]);
        } else if (words[0] == "vn") {
            const auto& n = vertices[normals++].normal;
            QVERIFY(words[1].toFloat() == n[0] && words[2].toFloat() == n[1] && words[3].toFloat() == n[2]);
        } else if (words[0] == "f") {
            QCOMPARE(words.size(), 4);
            for (int i = 1; i <= 3; ++i) {
                const std::size_t vertex = corners[corner++];
                const QByteArray index = QByteArray::number(static_cast<qulonglong>(vertex));
                const QByteArrayList numbers = words[i].split('/');
                QCOMPARE(numbers.mid(1), (QByteArrayList{index, index}));
                QVERIFY(positions.at(numbers[0].toULongLong() - 1) == toVec3(vertices[vertex - 1].position));
            }
        } else if (words[0] == "o" || words[0] == "usemtl" || words[0] == "mtllib") {
            objects.append(line);
        }
    }
    // The wood's surface is closed: what texture coordinates double has one position.
    QVERIFY(positions.size() < vertices.size());
    QCOMPARE(coordinates, vertices.size());
    QCOMPARE(normals, vertices.size());
    QCOMPARE(corner, corners.size());
    QCOMPARE(objects, (QByteArrayList{"mtllib my_oak.mtl", "o Oak_Bark_LOD0", "usemtl Oak_Bark",
                                      "o Oak_Leaves_LOD0", "usemtl Oak_Leaves"}));
    const QByteArray materials = contentOf(folder.filePath(QStringLiteral("my_oak.mtl")));
    int textures = 0;
    for (const QByteArray& line : materials.split('\n')) {
        if (line.startsWith("map_") || line.startsWith("norm ")) {
            ++textures;
            QVERIFY2(QFile::exists(folder.filePath(QString::fromUtf8(line.split(' ').last()))),
                     line.constData());
        }
    }
    QCOMPARE(textures, 9);
    // The normal map under both names that readers use.
    QCOMPARE(materials.count("\nmap_Bump my_oak_bark_normal.png\n"), 1);
    QCOMPARE(materials.count("\nnorm my_oak_bark_normal.png\n"), 1);
    QCOMPARE(materials.count("\nnorm my_oak_leaf_normal.png\n"), 1);
    QCOMPARE(materials.count("\nmap_d "), 1);
    QVERIFY(materials.contains("\nmap_d my_oak_leaf_mask.png\n"));
}

void ExporterTest::glb_hasNamesMaterialsAndTexturesInside()
{
    const QTemporaryDir folder;
    const TreeBuilder builder = sampleTree();
    const QString fileName = folder.filePath(QStringLiteral("oak.glb"));
    QVERIFY(exportTree(builder.tree, builder.index, QStringLiteral("Oak"), fileName, kSmall));
    QCOMPARE(filesIn(folder), QStringList{QStringLiteral("oak.glb")});
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(fileName.toStdString(), 0);
    QVERIFY2(scene != nullptr, importer.GetErrorString());
    QCOMPARE(scene->mNumMeshes, 2U);
    QCOMPARE(scene->mNumTextures, 6U);
    QVERIFY(scene->mRootNode->FindNode("Oak_Bark_LOD0") != nullptr);
    QVERIFY(scene->mRootNode->FindNode("Oak_Leaves_LOD0") != nullptr);
    const ExportScene original = buildExportScene(builder.tree, builder.index, QStringLiteral("Oak"), kSmall);
    for (unsigned i = 0; i < 2; ++i) {
        const aiMesh& mesh = *scene->mMeshes[i];
        QCOMPARE(std::size_t{mesh.mNumFaces}, original.meshes[i].mesh.indices.size() / 3);
        aiString name;
        scene->mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_NAME, name);
        QCOMPARE(QString::fromUtf8(name.C_Str()), original.materials[i].name);
        QVERIFY(mesh.HasTangentsAndBitangents());
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const auto& tangent = original.meshes[i].mesh.vertices[v].tangent;
            QVERIFY((mesh.mTangents[v] - aiVector3D(tangent[0], tangent[1], tangent[2])).Length() < 1e-5F);
        }
        for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_NORMALS})
            QCOMPARE(scene->mMaterials[mesh.mMaterialIndex]->GetTextureCount(type), 1U);
    }
    // glTF has the roughness in green and the metalness in blue.
    const ExportMaterial& bark = original.materials[0];
    aiString path;
    QCOMPARE(scene->mMaterials[scene->mMeshes[0]->mMaterialIndex]->GetTexture(
                 AI_MATKEY_GLTF_PBRMETALLICROUGHNESS_METALLICROUGHNESS_TEXTURE, &path),
             aiReturn_SUCCESS);
    const aiTexture* const packed = scene->GetEmbeddedTexture(path.C_Str());
    QVERIFY(packed != nullptr);
    const QImage surface =
        QImage::fromData(reinterpret_cast<const uchar*>(packed->pcData), int(packed->mWidth), "png");
    const QImage grey = QImage::fromData(bark.roughness.png, "png");
    QCOMPARE(surface.size(), grey.size());
    for (const QPoint place : {QPoint(0, 0), QPoint(13, 40), QPoint(63, 7)})
        QCOMPARE(surface.pixel(place) & 0xffffU, unsigned(qRed(grey.pixel(place))) << 8U);
    aiString mode;
    float cutoff = 0.0F;
    int twoSided = 0;
    const aiMaterial& leaf = *scene->mMaterials[scene->mMeshes[1]->mMaterialIndex];
    leaf.Get(AI_MATKEY_GLTF_ALPHAMODE, mode);
    leaf.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
    leaf.Get(AI_MATKEY_TWOSIDED, twoSided);
    QCOMPARE(QByteArray(mode.C_Str()), QByteArray("MASK"));
    QCOMPARE(cutoff, 0.5F);
    QCOMPARE(twoSided, 1);
}

void ExporterTest::fbx_isSoundAndCountsInMetres()
{
    const QTemporaryDir folder;
    const TreeBuilder builder = sampleTree();
    const QString fileName = folder.filePath(QStringLiteral("oak.fbx"));
    QVERIFY(exportTree(builder.tree, builder.index, QStringLiteral("Oak"), fileName, kSmall));
    QCOMPARE(filesIn(folder),
             (QStringList{QStringLiteral("oak.fbx"), QStringLiteral("oak_bark.png"),
                          QStringLiteral("oak_bark_normal.png"), QStringLiteral("oak_bark_roughness.png"),
                          QStringLiteral("oak_leaf.png"), QStringLiteral("oak_leaf_mask.png"),
                          QStringLiteral("oak_leaf_normal.png"), QStringLiteral("oak_leaf_roughness.png")}));
    const QByteArray content = contentOf(fileName);
    const Result<FbxDocument> repaired = repairFbx(content);
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QVERIFY(repaired && writeFbx(*repaired, bytes));
    QCOMPARE(bytes.data(), content); // nothing is left to repair
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(fileName.toStdString(), 0);
    QVERIFY2(scene != nullptr, importer.GetErrorString());
    QVERIFY(scene->mRootNode->FindNode("Oak_Bark_LOD0") != nullptr);
    QVERIFY(scene->mRootNode->FindNode("Oak_Leaves_LOD0") != nullptr);
    float unit = 0.0F;
    QVERIFY(scene->mMetaData->Get("UnitScaleFactor", unit));
    QCOMPARE(unit, 100.0F);
    const ExportScene original = buildExportScene(builder.tree, builder.index, QStringLiteral("Oak"), kSmall);
    const Box3 bounds = boundsOf(original.meshes[0].mesh);
    Box3 read;
    for (unsigned i = 0; i < scene->mMeshes[0]->mNumVertices; ++i) {
        const aiVector3D& v = scene->mMeshes[0]->mVertices[i];
        read.extend(Vec3(v.x, v.y, v.z));
    }
    QVERIFY((read.min() - bounds.min()).norm() < 1e-5F && (read.max() - bounds.max()).norm() < 1e-5F);
}

namespace {

/// The nodes of that name below "Objects" of an FBX file.
std::vector<const FbxNode*> objectsOf(const FbxDocument& document, const QByteArray& name)
{
    std::vector<const FbxNode*> found;
    for (const FbxNode& node : document.nodes) {
        for (const FbxNode& object : node.children) {
            if (node.name == "Objects" && object.name == name)
                found.push_back(&object);
        }
    }
    return found;
}

/// Name of an object, without its class.
QByteArray nameOf(const FbxNode& object)
{
    const QByteArray text = fbxText(object.properties.at(1)).value_or(QByteArray());
    return text.first(text.indexOf('\0'));
}

/// Number of a material's property; NaN if it has none of that name.
double numberOf(const FbxNode& material, const QByteArray& name)
{
    for (const FbxNode& list : material.children) {
        for (const FbxNode& property : list.children) {
            if (fbxText(property.properties.at(0)) == name)
                return qFromLittleEndian<double>(property.properties.at(4).constData() + 1);
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// Exports a sample as FBX and keeps the bytes that the nodes share.
struct ExportedFbx {
    QTemporaryDir folder;
    TreeBuilder builder = sampleTree();
    QByteArray content;
    FbxDocument document;

    ExportedFbx()
    {
        const QString fileName = folder.filePath(QStringLiteral("oak.fbx"));
        if (exportTree(builder.tree, builder.index, QStringLiteral("Oak"), fileName, kSmall))
            content = contentOf(fileName);
        if (std::optional<FbxDocument> read = readFbx(content))
            document = *std::move(read);
    }
};

} // namespace

void ExporterTest::fbx_hasNoTimeOfItsOwn()
{
    ExportedFbx fbx;
    for (FbxNode& node : fbx.document.nodes) {
        FbxNode* const stamp = node.child("CreationTimeStamp");
        if (stamp == nullptr)
            continue;
        QCOMPARE(stamp->child("Year")->properties.front(), fbxInteger(1970));
        QCOMPARE(stamp->child("Second")->properties.front(), fbxInteger(0));
        QCOMPARE(ExportedFbx().content, fbx.content);
        return;
    }
    QFAIL("there is no CreationTimeStamp");
}

void ExporterTest::fbx_namesItsTexturesImagesAndGeometries()
{
    const ExportedFbx fbx;
    QByteArrayList names;
    for (const FbxNode* object : objectsOf(fbx.document, "Video"))
        names.append(nameOf(*object));
    std::ranges::sort(names);
    QCOMPARE(names, (QByteArrayList{"oak_bark", "oak_bark_normal", "oak_bark_roughness", "oak_leaf",
                                    "oak_leaf_mask", "oak_leaf_normal", "oak_leaf_roughness"}));
    const std::vector<const FbxNode*> textures = objectsOf(fbx.document, "Texture");
    QCOMPARE(textures.size(), 9U);
    for (const FbxNode* texture : textures)
        QVERIFY2(names.contains(nameOf(*texture)), nameOf(*texture));
    QByteArrayList geometries;
    for (const FbxNode* object : objectsOf(fbx.document, "Geometry"))
        geometries.append(nameOf(*object));
    QCOMPARE(geometries, (QByteArrayList{"Oak_Bark_LOD0", "Oak_Leaves_LOD0"}));
}

void ExporterTest::fbx_hasTheGlossOfTheRoughness()
{
    const ExportedFbx fbx;
    const ExportScene scene =
        buildExportScene(fbx.builder.tree, fbx.builder.index, QStringLiteral("Oak"), kSmall);
    const std::vector<const FbxNode*> materials = objectsOf(fbx.document, "Material");
    QCOMPARE(materials.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(numberOf(*materials[i], "SpecularFactor"), 0.25);
        QVERIFY(std::isnan(numberOf(*materials[i], "ShininessFactor")));
        // Blender's rule.
        const double roughness = 1.0 - std::sqrt(numberOf(*materials[i], "Shininess")) / 10.0;
        QVERIFY(std::abs(roughness - scene.materials[i].meanRoughness) < 1e-3);
    }
}

void ExporterTest::fbx_takesTransparencyFromTheMask()
{
    const ExportedFbx fbx;
    std::vector<QByteArray> masks; // ids of the textures
    for (const FbxNode* texture : objectsOf(fbx.document, "Texture")) {
        if (nameOf(*texture) == "oak_leaf_mask")
            masks.push_back(texture->properties[0]);
    }
    QCOMPARE(masks.size(), 1U);
    int connections = 0;
    for (const FbxNode& node : fbx.document.nodes) {
        for (const FbxNode& connection : node.children) {
            if (node.name == "Connections" && connection.properties.size() == 4 &&
                fbxText(connection.properties[3]) == "TransparentColor") {
                ++connections;
                QCOMPARE(connection.properties[1], masks.front());
            }
        }
    }
    QCOMPARE(connections, 1);
}

void ExporterTest::mask_hasTheColoursAlphaInAllChannels()
{
    const TreeBuilder builder = sampleTree();
    const ExportScene scene = buildExportScene(builder.tree, builder.index, QStringLiteral("Oak"), kSmall);
    QVERIFY(scene.materials[0].mask.png.isEmpty());
    const QImage colour = QImage::fromData(scene.materials[1].colour.png, "png");
    const QImage mask = QImage::fromData(scene.materials[1].mask.png, "png");
    QCOMPARE(mask.size(), colour.size());
    int full = 0;
    int empty = 0;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            const int alpha = qAlpha(colour.pixel(x, y));
            QCOMPARE(mask.pixelColor(x, y).rgba(), qRgba(alpha, alpha, alpha, alpha));
            full += alpha == 255;
            empty += alpha == 0;
        }
    }
    QVERIFY(full > 100 && empty > 100);
}

void ExporterTest::barkOfALongAxis_keepsItsCoordinatesAsHalfFloats()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 400);
    const ExportScene scene = buildExportScene(builder.tree, builder.index, QStringLiteral("Oak"), kSmall);
    float worst = 0.0F;
    for (const MeshVertex& vertex : scene.meshes[0].mesh.vertices)
        worst = std::max(worst, std::abs(vertex.uv[1] - static_cast<float>(qfloat16(vertex.uv[1]))));
    // Half a step of the numbers below 8.
    QVERIFY2(worst <= 1.0F / 512.0F, qPrintable(QString::number(worst)));
}

void ExporterTest::roughnessAsANumber_isTheMeanOfTheTexture()
{
    const TreeBuilder builder = sampleTree();
    const QTemporaryDir folder;
    QVERIFY(exportTree(builder.tree, builder.index, QStringLiteral("Oak"),
                       folder.filePath(QStringLiteral("oak.obj")), kSmall));
    QList<double> exponents;
    for (const QByteArray& line : contentOf(folder.filePath(QStringLiteral("oak.mtl"))).split('\n')) {
        if (line.startsWith("Ns "))
            exponents.append(line.sliced(3).toDouble());
    }
    const ExportScene scene = buildExportScene(builder.tree, builder.index, QStringLiteral("Oak"), kSmall);
    QCOMPARE(exponents.size(), 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const QImage grey = QImage::fromData(scene.materials[i].roughness.png, "png");
        double sum = 0.0;
        for (int y = 0; y < grey.height(); ++y) {
            for (int x = 0; x < grey.width(); ++x)
                sum += qRed(grey.pixel(x, y)) / 255.0;
        }
        const double mean = sum / (grey.width() * grey.height());
        QVERIFY(std::abs(scene.materials[i].meanRoughness - mean) < 1e-6);
        // Blender's rule.
        QVERIFY(std::abs(1.0 - std::sqrt(exponents[qsizetype(i)] / 1000.0) - mean) < 1e-3);
    }
}

void ExporterTest::csv_hasARowForEachLivingInternode()
{
    const QTemporaryDir folder;
    TreeBuilder builder = sampleTree();
    InternodeId branch = 1;
    while (builder.tree.continuesAxis(branch))
        ++branch;
    builder.apply(death(builder.tree, builder.index, branch));
    const QString fileName = folder.filePath(QStringLiteral("oak.csv"));
    QVERIFY(exportTree(builder.tree, builder.index, {}, fileName, kSmall));
    QByteArrayList lines = contentOf(fileName).split('\n');
    QCOMPARE(lines.takeFirst(), QByteArray("id,parent,x0,y0,z0,x1,y1,z1,radius"));
    QVERIFY(lines.takeLast().isEmpty());
    QCOMPARE(static_cast<std::uint32_t>(lines.size()), builder.index.livingCount());
    QVERIFY(builder.index.livingCount() < builder.tree.size());
    const Widths widths(builder.tree, builder.index);
    QVERIFY(lines[0].startsWith("0,-1,0,0,0,"));
    for (const QByteArray& line : lines) {
        const QByteArrayList words = line.split(',');
        QCOMPARE(words.size(), 9);
        const InternodeId id = words[0].toUInt();
        QVERIFY(builder.tree.isAlive(id));
        if (id > 0)
            QCOMPARE(words[1].toUInt(), builder.tree.parent(id));
        const Vec3 base = builder.index.basePosition(builder.tree, id);
        const Vec3 node = builder.index.nodePosition(id);
        const float expected[] = {
            base.x(), -base.z(), base.y(), node.x(), -node.z(), node.y(), widths.radius(builder.index, id)};
        for (int i = 0; i < 7; ++i)
            QVERIFY(words[i + 2].toFloat() == expected[i]);
    }
}

void ExporterTest::sameTree_givesTheSameBytes()
{
    const QTemporaryDir folder;
    const TreeBuilder builder = sampleTree();
    const auto exported = [&](const char* suffix) {
        const QString fileName = folder.filePath(QStringLiteral("oak.") + QLatin1String(suffix));
        return exportTree(builder.tree, builder.index, QStringLiteral("Oak"), fileName, kSmall)
                   ? contentOf(fileName)
                   : QByteArray();
    };
    const std::vector<const char*> suffixes{"fbx", "glb", "obj", "csv"};
    std::vector<QByteArray> first;
    std::ranges::transform(suffixes, std::back_inserter(first), exported);
    QTest::qWait(1100); // A file that holds the time of the export would differ now.
    for (std::size_t i = 0; i < suffixes.size(); ++i) {
        QVERIFY(first[i].size() > 1000);
        QVERIFY2(exported(suffixes[i]) == first[i], suffixes[i]);
    }
}

void ExporterTest::exports_replaceEarlierOnes()
{
    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("oak.obj"));
    const TreeBuilder large = sampleTree(200);
    const TreeBuilder small = sampleTree(20);
    QVERIFY(exportTree(large.tree, large.index, {}, fileName, kSmall));
    const qint64 before = QFileInfo(fileName).size();
    QVERIFY(exportTree(small.tree, small.index, {}, fileName, kSmall));
    QVERIFY(QFileInfo(fileName).size() < before);
    QCOMPARE(filesIn(folder).size(), 9);
}

void ExporterTest::formats_areFoundByTheirEnding()
{
    QStringList suffixes;
    for (const ExportFormat* format : exportFormats()) {
        suffixes.append(format->suffix());
        QVERIFY(!format->name().isEmpty());
        QCOMPARE(exportFormatOf(QStringLiteral("some/Oak.old.") + format->suffix().toUpper()), format);
    }
    QCOMPARE(suffixes, exportSuffixes());
    QCOMPARE(suffixes.removeDuplicates(), 0);
    QCOMPARE(exportFormatOf(QStringLiteral("glb")), nullptr);
}

void ExporterTest::unknownEnding_isRefused()
{
    const TreeBuilder builder = sampleTree(20);
    const Result<void> result = exportTree(builder.tree, builder.index, {}, QStringLiteral("/tmp/oak.dae"));
    QVERIFY(!result);
    QCOMPARE(result.error().message,
             QStringLiteral("oak.dae: “.dae” is not an export format; the formats are glb, fbx, obj, csv"));
}

void ExporterTest::folderThatIsMissing_isAnError()
{
    const TreeBuilder builder = sampleTree(20);
    for (const QString& suffix : exportSuffixes()) {
        const Result<void> result =
            exportTree(builder.tree, builder.index, {}, QStringLiteral("/nowhere/oak.") + suffix, kSmall);
        QVERIFY(!result);
        QCOMPARE(result.error().kind, Error::Kind::Output);
        QVERIFY2(result.error().message.startsWith(QStringLiteral("oak")),
                 qPrintable(result.error().message));
    }
}

void ExporterTest::cancelling_leavesWhatWasThere_data()
{
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<int>("call");
    for (const QString& suffix : exportSuffixes()) {
        for (int call = 0; call < 3; ++call)
            QTest::addRow("%s at call %d", qPrintable(suffix), call) << suffix << call;
    }
}

void ExporterTest::cancelling_leavesWhatWasThere()
{
    QFETCH(QString, suffix);
    QFETCH(int, call);
    const QTemporaryDir folder;
    const TreeBuilder builder = sampleTree(20);
    QFile old(folder.filePath(QStringLiteral("oak.") + suffix));
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("old");
    old.close();
    int calls = 0;
    const Result<void> result = exportTree(builder.tree, builder.index, {}, old.fileName(), kSmall,
                                           [&](double) { return calls++ != call; });
    QVERIFY(!result);
    QCOMPARE(result.error().kind, Error::Kind::Cancelled);
    QCOMPARE(filesIn(folder), QStringList{QFileInfo(old).fileName()});
    QCOMPARE(contentOf(old.fileName()), QByteArray("old"));
}

void ExporterTest::progress_ascendsToOne()
{
    const QTemporaryDir folder;
    const TreeBuilder builder = sampleTree(20);
    std::vector<double> seen;
    QVERIFY(exportTree(builder.tree, builder.index, {}, folder.filePath(QStringLiteral("oak.glb")), kSmall,
                       [&](double done) {
                           seen.push_back(done);
                           return true;
                       }));
    QVERIFY(seen.size() >= 4);
    QVERIFY(std::ranges::is_sorted(seen));
    QCOMPARE(seen.front(), 0.0);
    QCOMPARE(seen.back(), 1.0);
}

static const TestClass<ExporterTest> exporterTest;

} // namespace espalier::test

#include "ExporterTest.moc"

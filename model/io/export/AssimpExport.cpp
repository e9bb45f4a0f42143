// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/AssimpExport.h"

#include "model/io/export/FbxRepair.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QImageWriter>

#include <assimp/Exporter.hpp>
#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace espalier {

namespace {

constexpr char kGlb[] = "glb2";
constexpr char kPlainGlb[] = "plain glb2";

/// Which of Assimp's slots a format takes its textures from.
enum class Slots { Gltf, Fbx };

aiString toAssimp(const QString& text)
{
    return aiString(text.toStdString());
}

/// An array as Assimp's structures own them.
template <class T>
T** makeArray(std::size_t count)
{
    return new T*[count];
}

aiMesh* convert(const ExportMesh& source)
{
    auto mesh = std::make_unique<aiMesh>();
    mesh->mName = toAssimp(source.name);
    mesh->mMaterialIndex = static_cast<unsigned>(source.material);
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    const auto& vertices = source.mesh.vertices;
    mesh->mNumVertices = static_cast<unsigned>(vertices.size());
    mesh->mVertices = new aiVector3D[vertices.size()];
    mesh->mNormals = new aiVector3D[vertices.size()];
    mesh->mTextureCoords[0] = new aiVector3D[vertices.size()];
    mesh->mNumUVComponents[0] = 2;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const MeshVertex& vertex = vertices[i];
        mesh->mVertices[i] = {vertex.position[0], vertex.position[1], vertex.position[2]};
        mesh->mNormals[i] = {vertex.normal[0], vertex.normal[1], vertex.normal[2]};
        mesh->mTextureCoords[0][i] = {vertex.uv[0], vertex.uv[1], 0.0F};
    }
    const auto& indices = source.mesh.indices;
    mesh->mNumFaces = static_cast<unsigned>(indices.size() / 3);
    mesh->mFaces = new aiFace[mesh->mNumFaces];
    for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
        aiFace& face = mesh->mFaces[i];
        face.mNumIndices = 3;
        face.mIndices = new unsigned[3]{indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]};
    }
    return mesh.release();
}

/// Where a material's textures are.
struct TexturePaths {
    QString colour;
    QString normal;
    QString roughness; ///< For glTF: roughness in green, metalness in blue
};

aiMaterial* convert(const ExportMaterial& source, const TexturePaths& paths, Slots slots)
{
    auto material = std::make_unique<aiMaterial>();
    const auto add = [&](const auto& value, const char* key, unsigned type = 0, unsigned index = 0) {
        material->AddProperty(&value, 1, key, type, index);
    };
    const auto addTexture = [&](const QString& path, aiTextureType type) {
        const aiString text = toAssimp(path);
        material->AddProperty(&text, AI_MATKEY_TEXTURE(type, 0));
    };
    const aiString name = toAssimp(source.name);
    material->AddProperty(&name, AI_MATKEY_NAME);
    // White, so that the texture's own colours show.
    const aiColor4D white(1.0F, 1.0F, 1.0F, 1.0F);
    add(white, AI_MATKEY_COLOR_DIFFUSE);
    add(white, AI_MATKEY_BASE_COLOR);
    add(0.0F, AI_MATKEY_METALLIC_FACTOR);
    add(1.0F, AI_MATKEY_ROUGHNESS_FACTOR);
    addTexture(paths.colour, aiTextureType_DIFFUSE);
    addTexture(paths.colour, aiTextureType_BASE_COLOR);
    addTexture(paths.normal, aiTextureType_NORMALS);
    if (slots == Slots::Gltf) {
        // The slot that Assimp's header calls METALLICROUGHNESS_TEXTURE.
        addTexture(paths.roughness, aiTextureType_UNKNOWN);
    } else {
        addTexture(paths.normal, aiTextureType_HEIGHT);
        // FBX's Phong knows no roughness. Blender writes and reads it here, and as it is.
        addTexture(paths.roughness, aiTextureType_SHININESS);
        // Dull and no metal: readers derive that from Phong's terms, and Assimp's defaults are those of a
        // mirror.
        const aiColor3D black(0.0F, 0.0F, 0.0F);
        add(black, AI_MATKEY_COLOR_SPECULAR);
        add(black, AI_MATKEY_COLOR_REFLECTIVE);
        add(0.0F, AI_MATKEY_REFLECTIVITY);
        add(0.1F, AI_MATKEY_SHININESS_STRENGTH);
        add(1.0F, AI_MATKEY_SHININESS);
    }
    if (source.isLeaf) {
        if (slots == Slots::Fbx)
            addTexture(paths.colour, aiTextureType_OPACITY);
        add(1, AI_MATKEY_TWOSIDED);
        const aiString mask("MASK");
        material->AddProperty(&mask, AI_MATKEY_GLTF_ALPHAMODE);
        add(0.5F, AI_MATKEY_GLTF_ALPHACUTOFF);
    }
    return material.release();
}

/// The roughness as glTF wants it: in green; metalness, of which there is none, in blue.
QByteArray metallicRoughness(const QByteArray& png)
{
    QImage image = QImage::fromData(png, "png").convertToFormat(QImage::Format_RGB888);
    for (int y = 0; y < image.height(); ++y) {
        uchar* pixel = image.scanLine(y);
        for (int x = 0; x < image.width(); ++x, pixel += 3) {
            pixel[0] = 0;
            pixel[2] = 0;
        }
    }
    QByteArray packed;
    QBuffer buffer(&packed);
    QImageWriter(&buffer, "png").write(image);
    return packed;
}

aiTexture* convert(const ExportTexture& source, const QString& name)
{
    auto texture = std::make_unique<aiTexture>();
    texture->mFilename = toAssimp(name);
    std::strcpy(texture->achFormatHint, "png");
    // A height of 0 says that the data is packed, and the width is its size; Assimp counts it in texels.
    const auto bytes = static_cast<std::size_t>(source.png.size());
    texture->mHeight = 0;
    texture->mWidth = static_cast<unsigned>(bytes);
    texture->pcData = new aiTexel[bytes / sizeof(aiTexel) + 1];
    std::memcpy(static_cast<void*>(texture->pcData), source.png.constData(), bytes);
    return texture.release();
}

/// The meshes, one a node under a node of the tree's name.
std::unique_ptr<aiScene> convertMeshes(const ExportScene& source)
{
    auto scene = std::make_unique<aiScene>();
    const std::size_t count = source.meshes.size();
    scene->mMeshes = makeArray<aiMesh>(count);
    scene->mRootNode = new aiNode(source.name.toStdString());
    scene->mRootNode->mChildren = makeArray<aiNode>(count);
    for (const ExportMesh& mesh : source.meshes) {
        auto* const node = new aiNode(mesh.name.toStdString());
        node->mParent = scene->mRootNode;
        node->mNumMeshes = 1;
        node->mMeshes = new unsigned[1]{scene->mNumMeshes};
        scene->mRootNode->mChildren[scene->mRootNode->mNumChildren++] = node;
        scene->mMeshes[scene->mNumMeshes++] = convert(mesh);
    }
    scene->mMaterials = makeArray<aiMaterial>(source.materials.size());
    return scene;
}

/// Assimp's own writer of binary glTF, without the steps before it: Assimp would look for vertices to weld,
/// which takes nine tenths of the time and finds none. Registers it under the name returned.
const char* registerPlainGlb(Assimp::Exporter& exporter)
{
    using Entry = Assimp::Exporter::ExportFormatEntry;
    static_assert(std::is_standard_layout_v<Entry> && offsetof(Entry, mDescription) == 0);
    for (std::size_t i = 0; i < exporter.GetExportFormatCount(); ++i) {
        const aiExportFormatDesc* const description = exporter.GetExportFormatDescription(i);
        if (std::strcmp(description->id, kGlb) != 0)
            continue;
        // A description is the first member of its entry.
        const auto* const entry = reinterpret_cast<const Entry*>(description);
        exporter.RegisterExporter({kPlainGlb, description->description, "glb", entry->mExportFunction});
        return kPlainGlb;
    }
    return kGlb;
}

/// Calls @p use(bytes) with the file that Assimp makes of the scene.
template <class Use>
Result<QByteArray> exported(Assimp::Exporter& exporter, const aiScene& scene, const char* format, Use&& use)
{
    const aiExportDataBlob* const blob = exporter.ExportToBlob(&scene, format);
    if (blob == nullptr) {
        return Error{Error::Kind::Output,
                     QCoreApplication::translate("Exporter", "the meshes could not be written: %1")
                         .arg(QString::fromUtf8(exporter.GetErrorString()))};
    }
    return use(QByteArrayView(static_cast<const char*>(blob->data), static_cast<qsizetype>(blob->size)));
}

} // namespace

Result<QByteArray> toGlb(const ExportScene& scene)
{
    const std::unique_ptr<aiScene> converted = convertMeshes(scene);
    converted->mTextures = makeArray<aiTexture>(3 * scene.materials.size());
    const auto embed = [&](const ExportTexture& texture) {
        converted->mTextures[converted->mNumTextures] =
            convert(texture, scene.name + QLatin1Char('_') + texture.name);
        return QStringLiteral("*%1").arg(converted->mNumTextures++);
    };
    for (const ExportMaterial& material : scene.materials) {
        const ExportTexture roughness{material.roughness.name, metallicRoughness(material.roughness.png)};
        const TexturePaths paths{embed(material.colour), embed(material.normal), embed(roughness)};
        converted->mMaterials[converted->mNumMaterials++] = convert(material, paths, Slots::Gltf);
    }
    Assimp::Exporter exporter;
    return exported(exporter, *converted, registerPlainGlb(exporter),
                    [](QByteArrayView bytes) -> Result<QByteArray> { return bytes.toByteArray(); });
}

Result<QByteArray> toFbx(const ExportScene& scene, const TextureFileName& textureFileName)
{
    const std::unique_ptr<aiScene> converted = convertMeshes(scene);
    for (const ExportMaterial& material : scene.materials) {
        const TexturePaths paths{textureFileName(material.colour), textureFileName(material.normal),
                                 textureFileName(material.roughness)};
        converted->mMaterials[converted->mNumMaterials++] = convert(material, paths, Slots::Fbx);
    }
    // FBX counts in centimetres unless it is told that a unit is a hundred of them.
    converted->mMetaData = aiMetadata::Alloc(1);
    converted->mMetaData->Set(0, "UnitScaleFactor", 100.0);
    Assimp::Exporter exporter;
    return exported(exporter, *converted, "fbx", [](QByteArrayView bytes) { return repairFbx(bytes); });
}

} // namespace espalier

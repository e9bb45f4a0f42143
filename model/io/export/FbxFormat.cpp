// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FbxFormat.h"

#include "model/base/WithinMemory.h"
#include "model/io/JsonReader.h"
#include "model/io/export/FbxGeometry.h"
#include "model/io/export/FbxRepair.h"
#include "model/io/export/SceneTextures.h"

#include <QCoreApplication>

#include <assimp/Exporter.hpp>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace espalier {

namespace {

aiString toAssimp(const QString& text)
{
    return aiString(text.toStdString());
}

/// An array in the form that Assimp's structures own.
template <class T>
T** makeArray(std::size_t count)
{
    return new T*[count];
}

/// A mesh of one triangle: the place of @p source, whose triangles setFbxTriangles() puts in.
aiMesh* placeFor(const ExportMesh& source)
{
    auto mesh = std::make_unique<aiMesh>();
    mesh->mName = toAssimp(source.name);
    mesh->mMaterialIndex = static_cast<unsigned>(source.material);
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = 3;
    mesh->mVertices = new aiVector3D[3]{{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    mesh->mNormals = new aiVector3D[3]{{0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}};
    mesh->mTextureCoords[0] = new aiVector3D[3]{{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    mesh->mNumUVComponents[0] = 2;
    mesh->mNumFaces = 1;
    mesh->mFaces = new aiFace[1];
    mesh->mFaces[0].mNumIndices = 3;
    mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
    return mesh.release();
}

/// Shininess that Blender's importer turns into the roughness, 0...1; other programs use it as the exponent
/// of a Phong highlight, which then looks dull.
float phongShininess(double roughness)
{
    const double smoothness = 10.0 * (1.0 - roughness);
    // Without any shininess Assimp would make a Lambert material.
    return static_cast<float>(std::max(1e-4, smoothness * smoothness));
}

aiMaterial* convert(const ExportMaterial& source, const ExportFiles& files)
{
    auto material = std::make_unique<aiMaterial>();
    const auto add = [&](const auto& value, const char* key, unsigned type = 0, unsigned index = 0) {
        material->AddProperty(&value, 1, key, type, index);
    };
    const auto addTexture = [&](const ExportTexture& texture, aiTextureType type) {
        const aiString text = toAssimp(files.name(textureEnding(texture)));
        material->AddProperty(&text, AI_MATKEY_TEXTURE(type, 0));
    };
    const aiString name = toAssimp(source.name);
    material->AddProperty(&name, AI_MATKEY_NAME);
    // White, so that the texture's own colours show.
    add(aiColor4D(1.0F, 1.0F, 1.0F, 1.0F), AI_MATKEY_COLOR_DIFFUSE);
    addTexture(source.colour, aiTextureType_DIFFUSE);
    addTexture(source.normal, aiTextureType_NORMALS);
    addTexture(source.normal, aiTextureType_HEIGHT);
    // FBX's Phong material has no roughness. Blender writes and reads the roughness texture in this slot,
    // unchanged.
    addTexture(source.roughness, aiTextureType_SHININESS);
    if (source.isLeaf)
        addTexture(source.mask, aiTextureType_OPACITY);
    // No metal, and the gloss of a plain dielectric: Blender reads the factor 0.25 as its (and glTF's)
    // standard of 0.5; its product with the colour is the reflectance of 4 % that other programs use.
    add(aiColor3D(0.0F, 0.0F, 0.0F), AI_MATKEY_COLOR_REFLECTIVE);
    add(0.0F, AI_MATKEY_REFLECTIVITY);
    add(aiColor3D(0.16F, 0.16F, 0.16F), AI_MATKEY_COLOR_SPECULAR);
    add(0.25F, AI_MATKEY_SHININESS_STRENGTH);
    add(phongShininess(source.meanRoughness), AI_MATKEY_SHININESS);
    return material.release();
}

/// Puts the triangles of all meshes into a document that has their places.
bool setTriangles(FbxDocument& document, const std::vector<ExportMesh>& meshes)
{
    const auto objects = std::ranges::find(document.nodes, "Objects", &FbxNode::name);
    if (objects == document.nodes.end())
        return false;
    std::size_t next = 0;
    for (FbxNode& object : objects->children) {
        if (object.name == "Geometry" &&
            (next >= meshes.size() || !setFbxTriangles(object, meshes[next++].mesh)))
            return false;
    }
    return next == meshes.size();
}

/// The places of the meshes, each in a node below one node with the tree's name.
std::unique_ptr<aiScene> sceneFor(const ExportScene& source)
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
        scene->mMeshes[scene->mNumMeshes++] = placeFor(mesh);
    }
    scene->mMaterials = makeArray<aiMaterial>(source.materials.size());
    return scene;
}

} // namespace

QString FbxFormat::name() const
{
    return QCoreApplication::translate("ExportFormat", "FBX");
}

Result<void> FbxFormat::write(const ExportScene& scene, ExportFiles& files) const
{
    if (Result<void> chosen = files.chooseNames(textureEndings(scene)); !chosen)
        return chosen;
    if (Result<void> added = addTextures(scene, files); !added)
        return added;
    const std::unique_ptr<aiScene> converted = sceneFor(scene);
    for (const ExportMaterial& material : scene.materials)
        converted->mMaterials[converted->mNumMaterials++] = convert(material, files);
    // FBX's unit is the centimetre unless the scale says that a unit is a hundred of them.
    converted->mMetaData = aiMetadata::Alloc(1);
    converted->mMetaData->Set(0, "UnitScaleFactor", 100.0);
    Assimp::Exporter exporter;
    const aiExportDataBlob* const blob = exporter.ExportToBlob(converted.get(), "fbx");
    const auto failure = [&](const QString& what) {
        return Error{Error::Kind::Output, inputError(files.mainName(), what).message};
    };
    if (blob == nullptr) {
        // Assimp has no words for that.
        if (*exporter.GetErrorString() == '\0')
            return memoryError();
        return failure(QCoreApplication::translate("Exporter", "the meshes could not be written: %1")
                           .arg(QString::fromUtf8(exporter.GetErrorString())));
    }
    Result<FbxDocument> document =
        repairFbx({static_cast<const char*>(blob->data), static_cast<qsizetype>(blob->size)});
    if (!document)
        return failure(document.error().message);
    if (!setTriangles(*document, scene.meshes))
        return files.tooLarge();
    return files.addMain([&](QIODevice& device) { return writeFbx(*document, device); });
}

} // namespace espalier

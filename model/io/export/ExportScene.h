// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"
#include "model/tree/TreeIndex.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace espalier {

/// Which parts of a tree are exported, and how finely.
struct ExportOptions {
    bool leaves = true;  ///< If the tree has any
    double detail = 1.0; ///< 0.1...2: multiplies the sides of a branch; at 1 the wood is off by 1 mm at most
    /// Pixels of a bark texture's edge, a power of two, 64...8192; a leaf has half of it.
    int textureSize = 1024;

    bool operator==(const ExportOptions&) const = default;
};

/// An image, packed as PNG.
struct ExportTexture {
    QString name; ///< "bark", "bark_normal", "bark_roughness": follows the tree's name in a file name
    QByteArray png;
};

struct ExportMaterial {
    QString name;
    ExportTexture colour;
    ExportTexture normal;
    ExportTexture roughness; ///< Grey: 0 a mirror, 255 chalk
    /// Leaves only: the colour's alpha in all four channels, for formats that name a mask beside the colour.
    /// Readers differ in which channel they use.
    ExportTexture mask;
    bool isLeaf = false; ///< The colour's alpha cuts the surface out, and it is seen from both sides
    /// Mean of the roughness texture, 0...1, for materials whose roughness is one number.
    double meanRoughness = 1.0;
};

struct ExportMesh {
    QString name;
    TriangleMesh mesh; ///< m, Y up, the seedling's base at the origin
    std::size_t material = 0;
};

/// One living internode as a straight bone.
struct ExportBone {
    InternodeId id = 0;
    InternodeId parent = kNoInternode;
    Vec3 base = Vec3::Zero(); ///< m, Y up
    Vec3 tip = Vec3::Zero();
    float radius = 0.0F; ///< m
};

/// Parts of a scene.
struct ExportParts {
    bool surface = false; ///< Meshes and materials
    bool skeleton = false;
};

/// A tree in the form that every format gets: meshes <Tree>_Bark_LOD0 and <Tree>_Leaves_LOD0, materials
/// <Tree>_Bark and <Tree>_Leaves. Game engines recognise levels of detail by names that end in _LOD and the
/// level's number.
///
/// The bark's texture coordinate v stays near 0, so that half floats keep it (see withSmallV()).
///
/// The hue of each leaf is in the texture: the leaves' texture is a row of one, two, four or eight tiles of
/// different hues, and a leaf's coordinates lie in the tile with the nearest hue. Half of the programs that
/// read the files drop or ignore vertex colours.
struct ExportScene {
    QString name;
    std::vector<ExportMesh> meshes;
    std::vector<ExportMaterial> materials;
    std::vector<ExportBone> skeleton; ///< By ascending id
};

/// @p name reduced to the characters that are valid in any file: letters, digits, "-" and "_"; "Tree" if
/// nothing is left.
QString safeExportName(const QString& name);

ExportScene buildExportScene(const Tree& tree, const TreeIndex& index, const QString& name,
                             const ExportOptions& options = {}, const ExportParts& parts = {.surface = true});

} // namespace espalier

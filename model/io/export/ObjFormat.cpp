// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/ObjFormat.h"

#include "model/io/export/SceneTextures.h"
#include "model/io/export/TextBlocks.h"
#include "model/mesh/Weld.h"

#include <QCoreApplication>

namespace espalier {

namespace {

/// The positions of a mesh. Those of wood are written once, so that a closed surface is closed for programs
/// that read the file, although texture coordinates double vertices. Leaves are apart anyway.
struct ObjPositions {
    explicit ObjPositions(const ExportMesh& mesh, bool isLeaf)
    {
        const auto& vertices = mesh.mesh.vertices;
        number.resize(vertices.size());
        const std::vector<VertexIndex> first =
            isLeaf ? std::vector<VertexIndex>() : firstAtSamePlace(vertices);
        for (VertexIndex i = 0; i < vertices.size(); ++i) {
            if (!isLeaf && first[i] != i) {
                number[i] = number[first[i]];
                continue;
            }
            number[i] = static_cast<VertexIndex>(written.size());
            written.push_back(i);
        }
    }

    std::vector<VertexIndex> written; ///< Vertices whose positions are written
    std::vector<VertexIndex> number;  ///< By vertex: of its position among those
};

bool writeObj(QIODevice& device, const ExportScene& scene, const QString& materialFileName)
{
    const auto writeLine = [&](const QByteArray& line) {
        return device.write(line + '\n') == line.size() + 1;
    };
    bool good = writeLine("mtllib " + materialFileName.toUtf8());
    // OBJ counts from 1, through all objects.
    std::uint64_t first = 1;
    std::uint64_t firstPosition = 1;
    for (const ExportMesh& mesh : scene.meshes) {
        const auto& vertices = mesh.mesh.vertices;
        const auto& indices = mesh.mesh.indices;
        const ObjPositions positions(mesh, scene.materials[mesh.material].isLeaf);
        good = good && writeLine("o " + mesh.name.toUtf8());
        good = good && writeBlocks(device, positions.written.size(), [&](TextBlock& block, std::size_t i) {
                   const auto& p = vertices[positions.written[i]].position;
                   block << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
               });
        good = good && writeBlocks(device, vertices.size(), [&](TextBlock& block, std::size_t i) {
                   block << "vt " << vertices[i].uv[0] << ' ' << vertices[i].uv[1] << '\n';
               });
        good = good && writeBlocks(device, vertices.size(), [&](TextBlock& block, std::size_t i) {
                   const auto& n = vertices[i].normal;
                   block << "vn " << n[0] << ' ' << n[1] << ' ' << n[2] << '\n';
               });
        good = good && writeLine("usemtl " + scene.materials[mesh.material].name.toUtf8());
        good = good && writeBlocks(device, indices.size() / 3, [&](TextBlock& block, std::size_t i) {
                   block << 'f';
                   for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner) {
                       const std::uint64_t index = first + indices[corner];
                       block << ' ' << firstPosition + positions.number[indices[corner]] << '/' << index
                             << '/' << index;
                   }
                   block << '\n';
               });
        first += vertices.size();
        firstPosition += positions.written.size();
    }
    return good;
}

/// Exponent of the Phong highlight for a roughness of 0...1: the formula of Blender's exporter, whose inverse
/// its importer applies. Programs that support the extension for physically based materials use Pr and map_Pr
/// instead.
double phongExponent(double roughness)
{
    const double smoothness = 1.0 - roughness;
    return 1000.0 * smoothness * smoothness;
}

QByteArray toMtl(const ExportScene& scene, const ExportFiles& files)
{
    QByteArray text;
    const auto line = [&](const char* key, const QByteArray& value) {
        text += key + QByteArray(" ") + value + '\n';
    };
    for (const ExportMaterial& material : scene.materials) {
        const auto map = [&](const char* key, const ExportTexture& texture) {
            line(key, files.name(textureEnding(texture)).toUtf8());
        };
        line("newmtl", material.name.toUtf8());
        line("Ka", "0 0 0");
        line("Kd", "1 1 1");
        // The values that Blender writes and reads for a surface that is not metal. "illum 1" says that there
        // is no highlight: programs without roughness would show one that is far too sharp.
        line("Ks", "0.5 0.5 0.5");
        line("Ns", QByteArray::number(phongExponent(material.meanRoughness), 'f', 3));
        line("illum", "1");
        map("map_Kd", material.colour);
        // Blender and many other programs read a normal map from map_Bump, readers of the extension from
        // norm.
        map("map_Bump", material.normal);
        map("norm", material.normal);
        line("Pm", "0");
        line("Pr", "1");
        map("map_Pr", material.roughness);
        if (material.isLeaf)
            map("map_d", material.mask);
    }
    return text;
}

} // namespace

QString ObjFormat::name() const
{
    return QCoreApplication::translate("ExportFormat", "Wavefront OBJ");
}

Result<void> ObjFormat::write(const ExportScene& scene, ExportFiles& files) const
{
    const QString materials = QStringLiteral(".mtl");
    if (Result<void> chosen = files.chooseNames(textureEndings(scene) << materials); !chosen)
        return chosen;
    if (Result<void> added = addTextures(scene, files); !added)
        return added;
    if (Result<void> added = files.addCompanion(materials, toMtl(scene, files)); !added)
        return added;
    return files.addMain([&](QIODevice& device) { return writeObj(device, scene, files.name(materials)); });
}

} // namespace espalier

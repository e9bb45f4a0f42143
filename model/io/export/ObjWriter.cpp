// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/ObjWriter.h"

#include "model/io/export/TextBlocks.h"

namespace espalier {

bool writeObj(QIODevice& device, const ExportScene& scene, const QString& materialFileName)
{
    const auto writeLine = [&](const QByteArray& line) {
        return device.write(line + '\n') == line.size() + 1;
    };
    bool good = writeLine("mtllib " + materialFileName.toUtf8());
    std::uint64_t first = 1; // OBJ counts from 1, through all objects
    for (const ExportMesh& mesh : scene.meshes) {
        const auto& vertices = mesh.mesh.vertices;
        const auto& indices = mesh.mesh.indices;
        good = good && writeLine("o " + mesh.name.toUtf8());
        good = good && writeBlocks(device, vertices.size(), [&](TextBlock& block, std::size_t i) {
                   const auto& p = vertices[i].position;
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
                       block << ' ' << index << '/' << index << '/' << index;
                   }
                   block << '\n';
               });
        first += vertices.size();
    }
    return good;
}

QByteArray toMtl(const ExportScene& scene, const TextureFileName& textureFileName)
{
    QByteArray text;
    for (const ExportMaterial& material : scene.materials) {
        const QByteArray colour = textureFileName(material.colour).toUtf8();
        text += "newmtl " + material.name.toUtf8() + "\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " +
                colour + "\nmap_Bump " + textureFileName(material.normal).toUtf8() + "\nPm 0\nPr 1\nmap_Pr " +
                textureFileName(material.roughness).toUtf8() + '\n';
        if (material.isLeaf)
            text += "map_d " + colour + '\n';
    }
    return text;
}

} // namespace espalier

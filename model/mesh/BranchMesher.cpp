// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/BranchMesher.h"

#include "model/base/Parallel.h"

namespace espalier {

namespace {

constexpr std::size_t kPiecesPerTask = 256;

} // namespace

BranchMesh meshBranches(const Tree& tree, const TreeIndex& index, const Widths& widths,
                        const WoodMeshOptions& options, const WoodMesher& mesher)
{
    BranchMesh mesh;
    for (const InternodeId base : mesher.pieces(tree, index))
        mesh.parts.push_back({.base = base});

    parallelFor(mesh.parts.size(), kPiecesPerTask, [&](std::size_t begin, std::size_t end) {
        const auto piece = mesher.pieceMesher(tree, index, widths, options);
        for (std::size_t i = begin; i < end; ++i)
            mesh.parts[i].size = piece->prepare(mesh.parts[i].base);
    });

    MeshSize total;
    for (BranchMesh::Part& part : mesh.parts) {
        part.firstVertex = total.vertices;
        part.firstIndex = total.indices;
        total.vertices += part.size.vertices;
        total.indices += part.size.indices;
    }
    mesh.vertices.resize(total.vertices);
    mesh.indices.resize(total.indices);
    mesh.origins.resize(total.vertices);

    parallelFor(mesh.parts.size(), kPiecesPerTask, [&](std::size_t begin, std::size_t end) {
        const auto piece = mesher.pieceMesher(tree, index, widths, options);
        for (std::size_t i = begin; i < end; ++i) {
            const BranchMesh::Part& part = mesh.parts[i];
            piece->prepare(part.base);
            piece->write(std::span(mesh.vertices).subspan(part.firstVertex, part.size.vertices),
                         std::span(mesh.indices).subspan(part.firstIndex, part.size.indices),
                         part.firstVertex);
            piece->writeOrigins(std::span(mesh.origins).subspan(part.firstVertex, part.size.vertices));
        }
    });
    return mesh;
}

} // namespace espalier

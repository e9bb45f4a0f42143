// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/BranchMesher.h"

#include "model/base/Parallel.h"
#include "model/mesh/Tubes.h"

namespace espalier {

namespace {

constexpr std::size_t kTubesPerTask = 256;

} // namespace

BranchMesh meshBranches(const Tree& tree, const TreeIndex& index, const Widths& widths,
                        const BranchMeshOptions& options)
{
    BranchMesh mesh;
    for (const InternodeId base : tubesOf(tree, index))
        mesh.parts.push_back({.base = base});

    parallelFor(mesh.parts.size(), kTubesPerTask, [&](std::size_t begin, std::size_t end) {
        TubeMesher mesher(tree, index, widths, options);
        for (std::size_t i = begin; i < end; ++i)
            mesh.parts[i].size = mesher.prepare(mesh.parts[i].base);
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

    parallelFor(mesh.parts.size(), kTubesPerTask, [&](std::size_t begin, std::size_t end) {
        TubeMesher mesher(tree, index, widths, options);
        for (std::size_t i = begin; i < end; ++i) {
            const BranchMesh::Part& part = mesh.parts[i];
            mesher.prepare(part.base);
            mesher.write(std::span(mesh.vertices).subspan(part.firstVertex, part.size.vertices),
                         std::span(mesh.indices).subspan(part.firstIndex, part.size.indices),
                         part.firstVertex);
        }
    });
    return mesh;
}

} // namespace espalier

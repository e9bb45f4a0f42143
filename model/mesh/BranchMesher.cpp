// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/BranchMesher.h"

#include "model/base/Parallel.h"

namespace espalier {

namespace {

constexpr std::size_t kAxesPerTask = 256;

} // namespace

std::vector<InternodeId> livingAxes(const Tree& tree, const TreeIndex& index)
{
    std::vector<InternodeId> axes;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (index.axis(id) == id && tree.isAlive(id))
            axes.push_back(id);
    }
    return axes;
}

BranchMesh meshBranches(const Tree& tree, const TreeIndex& index, const Widths& widths,
                        const BranchMeshOptions& options)
{
    BranchMesh mesh;
    for (const InternodeId axis : livingAxes(tree, index))
        mesh.parts.push_back({.axis = axis});

    parallelFor(mesh.parts.size(), kAxesPerTask, [&](std::size_t begin, std::size_t end) {
        AxisMesher mesher(tree, index, widths, options);
        for (std::size_t i = begin; i < end; ++i)
            mesh.parts[i].size = mesher.prepare(mesh.parts[i].axis);
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

    parallelFor(mesh.parts.size(), kAxesPerTask, [&](std::size_t begin, std::size_t end) {
        AxisMesher mesher(tree, index, widths, options);
        for (std::size_t i = begin; i < end; ++i) {
            const BranchMesh::Part& part = mesh.parts[i];
            mesher.prepare(part.axis);
            mesher.write(std::span(mesh.vertices).subspan(part.firstVertex, part.size.vertices),
                         std::span(mesh.indices).subspan(part.firstIndex, part.size.indices),
                         part.firstVertex);
        }
    });
    return mesh;
}

} // namespace espalier

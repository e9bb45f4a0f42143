// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/AxisMesher.h"

#include <vector>

namespace espalier {

/// The wood of a whole tree.
struct BranchMesh : TriangleMesh {
    /// Where one axis' tube is.
    struct Part {
        InternodeId axis = 0; ///< Its first internode
        std::uint32_t firstVertex = 0;
        std::uint32_t firstIndex = 0;
        MeshSize size{};
    };
    std::vector<Part> parts; ///< By ascending axis
};

/// The living axes of a tree, ascending.
std::vector<InternodeId> livingAxes(const Tree& tree, const TreeIndex& index);

/// Meshes every living axis (see AxisMesher), in parallel and with the same result on one thread or many.
BranchMesh meshBranches(const Tree& tree, const TreeIndex& index, const Widths& widths,
                        const BranchMeshOptions& options = {});

} // namespace espalier

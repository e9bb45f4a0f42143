// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/WoodMesher.h"

#include <vector>

namespace espalier {

/// The wood of a whole tree.
struct BranchMesh : TriangleMesh {
    /// Where one piece is.
    struct Part {
        InternodeId base = 0; ///< First internode of the piece
        std::uint32_t firstVertex = 0;
        std::uint32_t firstIndex = 0;
        MeshSize size{};
    };
    std::vector<Part> parts;         ///< By ascending base
    std::vector<WoodOrigin> origins; ///< Of the vertices
};

/// Meshes every piece into which @p mesher divides the tree, in parallel and with the same result on one
/// thread or many.
BranchMesh meshBranches(const Tree& tree, const TreeIndex& index, const Widths& widths,
                        const WoodMeshOptions& options = {}, const WoodMesher& mesher = tubeWood());

} // namespace espalier

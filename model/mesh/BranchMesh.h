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
    std::vector<Part> parts;        ///< By ascending base
    MeshBuffer<WoodOrigin> origins; ///< Of the vertices
};

} // namespace espalier

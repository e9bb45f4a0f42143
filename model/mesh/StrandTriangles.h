// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/WorkProgress.h"
#include "model/mesh/StrandSections.h"

#include <array>
#include <vector>

namespace espalier {

/// Where the triangles of each node of a mesh of strands are among its indices.
struct StrandTriangles {
    struct Node {
        std::uint32_t first = 0; ///< The node's first triangle
        std::uint32_t count = 0;
        std::uint32_t toBelow = 0; ///< So many of the first ones have vertices of the node below
        std::uint32_t toAbove = 0; ///< So many of the last ones have vertices of the nodes above
        std::uint32_t firstLink = 0;
        std::uint32_t linkCount = 0;
        bool isIncomplete = false; ///< Some were removed; then toBelow and toAbove say nothing
    };
    /// The first vertices of two loops that triangles connect.
    using Link = std::array<VertexIndex, 2>;

    std::vector<Node> nodes;
    std::vector<Link> links;
    /// For each of the mesh's last vertices, which are doubles, the one that it doubles.
    std::vector<VertexIndex> doubled;
};

/// Makes the triangles between all sections, and sets the indices of @p mesh. Triangles of nodes that @p
/// reuse has come from the last mesh. If @p progress is cancelled meanwhile, the result is of no use.
StrandTriangles triangulateStrands(const StrandLayouts& layouts, const StrandTubes& tubes,
                                   const StrandSections& sections, const StrandReuse& reuse,
                                   const StrandSections::Last& last, const StrandTriangles* lastTriangles,
                                   WorkProgress& progress, BranchMesh& mesh);

/// Removes surfaces that enclose no wood: those of cavities that are closed on all sides, which are not seen,
/// and scraps of strands that stray between parts. Their vertices stay.
void removeVoids(const StrandLayouts& layouts, const StrandTubes& tubes, const StrandSections& sections,
                 StrandTriangles& triangles, BranchMesh& mesh);

} // namespace espalier

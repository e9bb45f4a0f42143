// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/StrandTriangles.h"

namespace espalier {

/// By node: whether triangles at its vertices can have one of the vertices @p raised.
std::vector<std::uint8_t> nodesNear(std::span<const RaisedVertex> raised, const StrandLayouts& layouts,
                                    const StrandSections& sections);

/// Sets the normals and tangents of the vertices of @p mesh, which has all its triangles. Normals are
/// weighted by the areas of the triangles around a vertex. Tangents follow the loops, so the bitangent rises
/// with the branch. Those of nodes that @p reuse has are there already, except for nodes @p isChanged.
void orientStrands(const StrandLayouts& layouts, const StrandSections& sections,
                   const StrandTriangles& triangles, const StrandReuse& reuse,
                   std::span<const std::uint8_t> isChanged, WorkProgress& progress, BranchMesh& mesh);

/// Doubles the vertices of triangles across which u starts again, and appends the doubles, node by node.
/// Returns for each of them the vertex that it doubles.
std::vector<VertexIndex> splitSeams(const StrandTriangles& triangles, BranchMesh& mesh);

} // namespace espalier

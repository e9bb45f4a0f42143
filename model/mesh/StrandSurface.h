// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/StrandTriangles.h"

namespace espalier {

/// Sets the normals and tangents of the vertices of @p mesh, which has all its triangles. Normals are
/// weighted by the areas of the triangles around a vertex. Tangents follow the loops, so the bitangent rises
/// with the branch. Those of nodes that @p reuse has are there already.
void orientStrands(const StrandLayouts& layouts, const StrandSections& sections,
                   const StrandTriangles& triangles, const StrandReuse& reuse, const WorkProgress& progress,
                   BranchMesh& mesh);

/// Doubles the vertices of triangles across which u starts again, and appends the doubles, node by node.
/// Returns for each of them the vertex that it doubles.
std::vector<VertexIndex> splitSeams(const StrandTriangles& triangles, BranchMesh& mesh);

} // namespace espalier

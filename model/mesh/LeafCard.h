// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/LeafInstance.h"
#include "model/mesh/Mesh.h"
#include "model/tree/Parameters.h"

#include <span>
#include <vector>

namespace espalier {

/// The mesh that all leaves of one shape share. In leaf space: x in widths from the midrib, y in lengths from
/// the petiole, z in widths out of the upper face. A leaf stands at position + rotation (x width, y length, z
/// width); normals and tangents are only rotated.
struct LeafCard {
    std::vector<MeshVertex> vertices;
    std::vector<VertexIndex> indices;
};

/// Six triangles for a simple leaf: folded along the midrib, arched, and cut off at the corners that its
/// texture leaves empty; eight for a leaf of several blades, which has no such corners; twenty for a frond;
/// twelve for the user's own image. Four for needles: two crossed cards.
const LeafCard& leafCard(LeafShape shape);

struct LeafMeshOptions {
    /// 0...1: how far normals turn from the leaf's own to the direction out of the crown, which makes crowns
    /// look like a volume under game engines' lights.
    double roundness = 0.0;
    Vec3 crownCentre = Vec3::Zero(); ///< m

    bool operator==(const LeafMeshOptions&) const = default;
};

/// One plain mesh of all leaves of positive length, for export. Its triangles must be drawn from both sides.
TriangleMesh expandLeaves(std::span<const LeafInstance> leaves, const LeafMeshOptions& options = {});

} // namespace espalier

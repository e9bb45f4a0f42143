// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

#include <cstdint>

namespace espalier {

/// What is wrong with a surface that ought to be closed. Vertices at exactly the same place count as one,
/// since texture coordinates double them.
struct SurfaceFaults {
    std::uint64_t openEdges = 0;           ///< With one triangle
    std::uint64_t nonManifoldEdges = 0;    ///< With more than two triangles, or two of the same direction
    std::uint64_t nonManifoldVertices = 0; ///< Whose triangles form more than one fan
    std::uint64_t degenerate = 0;          ///< Triangles with a corner twice, or no area
    std::uint64_t components = 0;
    std::uint64_t inverted = 0;          ///< Components whose signed volume is not above 0
    std::uint64_t selfIntersections = 0; ///< Pairs of triangles that cross; only if looked for

    bool isClosed() const
    {
        return openEdges == 0 && nonManifoldEdges == 0 && nonManifoldVertices == 0 && degenerate == 0 &&
               inverted == 0;
    }
};

/// @p withIntersections: also looks for triangles that cross, which takes some times longer.
SurfaceFaults checkSurface(const TriangleMesh& mesh, bool withIntersections = false);

/// The volume within a closed surface, m³.
double enclosedVolume(const TriangleMesh& mesh);

} // namespace espalier

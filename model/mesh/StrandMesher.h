// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/BranchMesh.h"
#include "model/mesh/StrandTriangles.h"

#include <memory>

namespace espalier {

/// A mesh of strands, with what the next one can take over.
struct StrandWood {
    std::shared_ptr<const BranchMesh> mesh;
    std::shared_ptr<const StrandLayouts> layouts;
    StrandKeys keys;
    StrandTubes tubes;
    std::vector<StrandSections::Block> blocks;
    StrandTriangles triangles;
    std::vector<RaisedVertex> raised;
    std::vector<std::uint8_t> isNearRaised; ///< By node: see nodesNear
    std::size_t taken = 0; ///< Number of nodes whose vertices and triangles came from the mesh before
};

/// One closed surface around all strands of a tree (Strands 2024 §5.5), for each of its roots.
///
/// Between two nodes each bundle has cross-sections; the outline of a section is a loop of strands, and loops
/// of successive sections are joined strand by strand. Where bundles divide or meet, the region between the
/// outline below and those above is triangulated in the plane of the section (PlanarPatch). So each edge has
/// two triangles, whatever the shape is. Bundles of few strands get rings. Tips and bases are closed.
///
/// u follows the strands around a bundle, v its length, so the bark turns with a twist and flows through
/// forks. Vertices are doubled only where u starts again.
///
/// What has not changed since @p last, the last mesh of the tree or of another one, is taken from there; it
/// can be null. The result is the same with and without it, and on one thread and many. Null if @p progress
/// was cancelled.
std::shared_ptr<const StrandWood> meshStrands(std::shared_ptr<const StrandLayouts> layouts,
                                              const TreeParameters& parameters,
                                              const WoodMeshOptions& options, const StrandWood* last,
                                              WorkProgress& progress);

/// The same without a last mesh.
BranchMesh meshStrands(const StrandLayouts& layouts, const TreeParameters& parameters,
                       const WoodMeshOptions& options = {});

} // namespace espalier

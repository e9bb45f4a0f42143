// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/BranchMesh.h"
#include "model/mesh/FlatTriangles.h"
#include "model/mesh/StrandTubes.h"
#include "model/strands/StrandCurves.h"

#include <span>
#include <vector>

namespace espalier {

/// The cross-sections of all tubes of a tree, with the positions of their vertices.
class StrandSections {
public:
    /// A closed line of vertices.
    struct Loop {
        VertexIndex first = 0;
        std::uint32_t count = 0;
        std::uint32_t firstStrand = 0; ///< Into the node's strands; its vertices' strands follow one another
        bool hasStrands = false;
        std::uint32_t node = 0; ///< Whose numbers the strands have
    };
    /// The loops of one bundle at one place: first the one around the wood.
    struct Slice {
        std::vector<Loop> loops;
        float along = 0.0F; ///< From the node below (0) to the node (1)
        Vec3 centre = Vec3::Zero();
        float radius = 0.0F; ///< m, of the bundle
    };
    /// The vertices of one node: from the node below up to it, and as far above as its branches are joined.
    struct Block {
        std::vector<Slice> slices;              ///< Of all tubes, tube by tube, upward
        std::vector<std::uint32_t> firstSlices; ///< Of each tube, and the number of all
        /// The outline at the node, and those above it where its branches are joined.
        std::vector<Slice> whole;
        std::vector<std::uint32_t> strands; ///< Of the loops
        VertexIndex first = 0;
        std::uint32_t count = 0;
        VertexIndex apex = 0; ///< Of a tip, or the middle of a base whose outline is round
        bool hasApex = false;

        std::span<const Slice> slicesOf(std::size_t tube) const
        {
            return std::span(slices).subspan(firstSlices[tube], firstSlices[tube + 1] - firstSlices[tube]);
        }
        const Slice& top() const { return whole.back(); }
    };

    /// The sections of the last mesh.
    struct Last {
        const std::vector<Block>* blocks = nullptr;
        const BranchMesh* mesh = nullptr;
        std::span<const RaisedVertex> raised; ///< Those that were moved after the sections had been made
    };

    /// Writes the vertices of all sections to @p mesh, which must outlive this object: positions and origins.
    /// Those of nodes that @p reuse has come from @p last as they are. If @p progress is cancelled
    /// meanwhile, the result is of no use.
    StrandSections(const StrandLayouts& layouts, const StrandTubes& tubes, const TreeParameters& parameters,
                   const StrandReuse& reuse, const Last& last, WorkProgress& progress, BranchMesh& mesh);

    const Block& block(std::uint32_t node) const { return m_blocks[node]; }
    std::span<const std::uint32_t> strands(const Loop& loop) const
    {
        return loop.hasStrands ? std::span(m_blocks[loop.node].strands).subspan(loop.firstStrand, loop.count)
                               : std::span<const std::uint32_t>();
    }
    /// Coordinates of a loop's strands in the section of its node, before the node's turn.
    std::vector<Vec2> plane(const Loop& loop) const;
    Vec3 position(VertexIndex vertex) const { return toVec3(m_vertices[vertex].position); }
    std::vector<Block> takeBlocks() { return std::move(m_blocks); }

private:
    class Writer;

    void plan(std::uint32_t node);
    void take(std::uint32_t node, const StrandReuse& reuse, const Last& last);

    const StrandLayouts& m_layouts;
    const StrandTubes& m_tubes;
    float m_smoothing;
    std::vector<Block> m_blocks;
    MeshBuffer<MeshVertex>& m_vertices;
    MeshBuffer<WoodOrigin>& m_origins;
};

} // namespace espalier

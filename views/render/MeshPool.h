// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/WoodTracker.h"
#include "views/render/RunAllocator.h"

#include <memory>
#include <span>
#include <vector>

namespace espalier {

/// The mesh of a growing tree on the graphics card, updated delta by delta, in three arrays: vertices and
/// indices of the wood, instances of the leaves. Each piece of wood (see WoodMesher) has a run of each, with
/// some slack. Unused places of the index array are degenerate triangles (0, 0, 0), those of the leaf array
/// are hidden leaves, so that both arrays can be drawn as a whole.
///
/// WoodTracker records which pieces have to be meshed, and how exact they are; settle() makes all pieces
/// exact, when there is time. After that, the contents are a function of the tree and the options alone; the
/// places of the runs are not.
class MeshPool {
public:
    /// Meshes a whole tree again.
    void rebuild(const Tree& tree, const TreeIndex& index);
    /// Notes the pieces that @p delta, which @p tree and @p index have just applied or reverted, and a change
    /// of the parameters put out of date. Call it for each delta, and finish() before the mesh is used: a
    /// piece that many deltas change is meshed once.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    /// Meshes all pieces that follow() has noted.
    void finish(const Tree& tree, const TreeIndex& index);
    /// Meshes at most @p pieces of them, those that have waited longest first; the others stay as they were.
    /// Pieces that have died are removed at once. Returns whether nothing is left.
    bool finishSome(const Tree& tree, const TreeIndex& index, std::size_t pieces);
    /// Meshes the pieces that are within the tolerance but not exact; returns whether there were any.
    bool settle(const Tree& tree, const TreeIndex& index);
    /// Notes those pieces for finish(), which must have nothing left; returns whether there are any.
    bool noteInexact(const Tree& tree, const TreeIndex& index) { return m_tracker.noteInexact(tree, index); }
    /// Sets how fine the wood is, from the next finish() on.
    void setOptions(const WoodMeshOptions& options) { m_tracker.setOptions(options); }
    const WoodMeshOptions& options() const { return m_tracker.options(); }
    /// The wood as strands, if it is shown so: from the next finish() on, leaves stand on it, not on the
    /// tubes. Null for tubes.
    void setLines(std::shared_ptr<const StrandLines> lines);

    std::span<const MeshVertex> vertices() const { return m_vertices; }
    std::span<const VertexIndex> indices() const { return m_indices; }
    std::span<const LeafInstance> leaves() const { return m_leaves; }

    /// Elements from begin up to but not including end.
    struct Range {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        bool operator==(const Range&) const = default;
    };
    struct Changes {
        std::vector<Range> vertices;
        std::vector<Range> indices;
        std::vector<Range> leaves;
        bool isEmpty() const { return vertices.empty() && indices.empty() && leaves.empty(); }
    };
    /// The ranges that changed since the last call, ascending and disjoint. Neighbouring ranges are joined
    /// where fewer calls cost less than more bytes.
    Changes takeChanges();

    /// The runs of a piece's mesh and leaves.
    struct Piece {
        Run vertices;
        Run indices;
        Run leaves;
        MeshSize size;
        std::uint32_t leafCount = 0;
    };
    /// The piece that begins with internode @p base; null if there is none.
    const Piece* piece(InternodeId base) const;
    /// The record of what the pieces were meshed with.
    const WoodTracker& tracker() const { return m_tracker; }

    std::size_t bytes() const;

private:
    struct Needs;

    void mesh(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> bases, bool withWood);
    void reserve(Piece& piece, const Needs& needs, bool withWood);
    void release(Piece& piece);
    void releaseIndices(const Run& run);
    void releaseLeaves(const Run& run);

    WoodTracker m_tracker;
    std::shared_ptr<const StrandLines> m_lines;
    MeshBuffer<MeshVertex> m_vertices;
    MeshBuffer<VertexIndex> m_indices;
    MeshBuffer<LeafInstance> m_leaves;
    RunAllocator m_vertexRuns;
    RunAllocator m_indexRuns;
    RunAllocator m_leafRuns;
    Changes m_changes;

    std::vector<Piece> m_pieces; ///< By internode; internodes that begin no piece have one without vertices
};

} // namespace espalier

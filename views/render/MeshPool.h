// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/WoodTracker.h"
#include "views/render/RunAllocator.h"

#include <span>
#include <vector>

namespace espalier {

/// The mesh of a growing tree as it lies on the graphics card, kept up to date delta by delta in three
/// arrays: vertices and indices of the wood, instances of the leaves. Each piece of wood (see WoodMesher) has
/// a run of each, with some slack; unused places of the index array are degenerate triangles (0, 0, 0), those
/// of the leaf array hidden leaves, so that both may be drawn as a whole.
///
/// WoodTracker says what has to be meshed, and how exact it is; settle() brings everything up to date, when
/// there is time. Given that, the contents are a function of the tree and the options alone, however it came
/// about; where they lie is not.
class MeshPool {
public:
    /// Starts anew.
    void rebuild(const Tree& tree, const TreeIndex& index);
    /// Notes what @p delta, which @p tree and @p index have just applied or reverted, and other parameters in
    /// force will change. To be called for each delta, and finish() before the next look at the mesh: what
    /// many deltas change is meshed once.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    /// Meshes what follow() has noted.
    void finish(const Tree& tree, const TreeIndex& index);
    /// Meshes some of it, at most so many pieces, those that have waited longest first; the others stay as
    /// they were. Returns whether nothing is left. What has died is gone at once.
    bool finishSome(const Tree& tree, const TreeIndex& index, std::size_t pieces);
    /// Meshes anew what is within the tolerance but not exact; returns whether there was any.
    bool settle(const Tree& tree, const TreeIndex& index);
    /// Notes the same for finish(), which must have nothing left; returns whether there is any.
    bool noteInexact(const Tree& tree, const TreeIndex& index) { return m_tracker.noteInexact(tree, index); }
    /// How fine the wood is, from the next finish() on.
    void setOptions(const WoodMeshOptions& options) { m_tracker.setOptions(options); }
    const WoodMeshOptions& options() const { return m_tracker.options(); }

    std::span<const MeshVertex> vertices() const { return m_vertices; }
    std::span<const VertexIndex> indices() const { return m_indices; }
    std::span<const LeafInstance> leaves() const { return m_leaves; }

    /// Elements from begin to before end.
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
    /// What changed since the last call, ascending and disjoint; neighbours are joined where that saves more
    /// calls than bytes.
    Changes takeChanges();

    /// Where the mesh and the leaves of a piece are.
    struct Piece {
        Run vertices;
        Run indices;
        Run leaves;
        MeshSize size;
        std::uint32_t leafCount = 0;
    };
    /// Of the piece that begins with internode @p base; null if none does.
    const Piece* piece(InternodeId base) const;
    /// What the pieces were meshed with.
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
    MeshBuffer<MeshVertex> m_vertices;
    MeshBuffer<VertexIndex> m_indices;
    MeshBuffer<LeafInstance> m_leaves;
    RunAllocator m_vertexRuns;
    RunAllocator m_indexRuns;
    RunAllocator m_leafRuns;
    Changes m_changes;

    std::vector<Piece> m_pieces; ///< By internode; without vertices for those that begin none
};

} // namespace espalier

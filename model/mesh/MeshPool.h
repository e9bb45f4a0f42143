// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/LeafPlacer.h"
#include "model/mesh/RunAllocator.h"
#include "model/mesh/TubeMesher.h"

#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// The mesh of a growing tree, kept up to date delta by delta, in three arrays that a view can hold on the
/// graphics card: vertices and indices of the wood, instances of the leaves. Each tube (see Tubes.h) has a
/// run of each, with some slack; unused places of the index array are degenerate triangles (0, 0, 0), those
/// of the leaf array hidden leaves, so that both may be drawn as a whole.
///
/// Changes cost in proportion to the tubes that they touch, not to the tree. A tube whose branches have only
/// thickened is left as it is until one of its radii is off by more than kTolerance; settle() brings
/// everything up to date, when there is time. Given that, the contents are a function of the tree alone,
/// however it came about; where they lie is not.
class MeshPool {
public:
    static constexpr float kTolerance = 0.02F;

    explicit MeshPool(const BranchMeshOptions& options = {}) : m_options(options) {}

    /// Starts anew.
    void rebuild(const Tree& tree, const TreeIndex& index);
    /// Notes what @p delta, which @p tree and @p index have just applied or reverted, and other parameters in
    /// force will change. To be called for each delta, and finish() before the next look at the mesh: what
    /// many deltas change is meshed once.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    /// Meshes what follow() has noted.
    void finish(const Tree& tree, const TreeIndex& index);
    /// Meshes some of it, at most so many tubes, those that have waited longest first; the others stay as
    /// they were. Returns whether nothing is left. What has died is gone at once.
    bool finishSome(const Tree& tree, const TreeIndex& index, std::size_t tubes);
    /// Meshes anew what is within the tolerance but not exact; returns whether there was any.
    bool settle(const Tree& tree, const TreeIndex& index);
    /// Notes the same for finish(), which must have nothing left; returns whether there is any.
    bool noteInexact(const Tree& tree, const TreeIndex& index);

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

    /// Where a tube's mesh and leaves are.
    struct Tube {
        Run vertices;
        Run indices;
        Run leaves;
        MeshSize size;
        std::uint32_t leafCount = 0;
        float parentRadius = 0.0F; ///< m, that it was meshed with
    };
    /// Of the tube that begins with internode @p base; null if none does.
    const Tube* tube(InternodeId base) const;
    /// The radius that an internode was meshed with, m.
    float meshedRadius(InternodeId id) const { return m_radius[id]; }

    std::size_t bytes() const;

private:
    struct Needs;

    void collectTouched(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    void collectChanged(const Tree& tree, const TreeIndex& index);
    void collectRange(const Tree& tree, const TreeIndex& index, IdRange range, float tolerance);
    void inspect(const Tree& tree, const TreeIndex& index, InternodeId id, float tolerance);
    void checkRadius(const TreeIndex& index, InternodeId id, float tolerance);
    void resize(std::uint32_t size);
    void startRound();
    void followWidths(const Tree& tree, const TreeIndex& index);
    void forget(InternodeId id);
    void collectWaiting(const Tree& tree);
    void releaseInner(std::span<const InternodeId> bases);
    void meshTubes(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> bases,
                   bool withWood);
    void reserve(Tube& tube, const Needs& needs, bool withWood);
    void release(Tube& tube);
    void releaseIndices(const Run& run);
    void releaseLeaves(const Run& run);

    BranchMeshOptions m_options;
    TreeParameters m_parameters;
    std::optional<Widths> m_widths;
    bool m_widthsAreStale = false; ///< Only with constraints, or where they were
    // Exponent of the widths when this round of checks began, and the one before: every radius has been
    // looked at since that one.
    double m_roundExponent = 0.0;
    double m_checkedExponent = 0.0;
    InternodeId m_nextCheck = 0;

    MeshBuffer<MeshVertex> m_vertices;
    MeshBuffer<VertexIndex> m_indices;
    MeshBuffer<LeafInstance> m_leaves;
    RunAllocator m_vertexRuns;
    RunAllocator m_indexRuns;
    RunAllocator m_leafRuns;
    Changes m_changes;

    // By internode
    std::vector<Tube> m_tubes;               ///< Without vertices for those that begin none
    std::vector<InternodeId> m_continuation; ///< As meshed
    std::vector<float> m_radius;             ///< m, as meshed
    std::vector<std::uint8_t> m_bears;       ///< Leaves, as placed
    std::vector<std::uint32_t> m_inspected;  ///< Number of the update in which it was
    std::vector<std::uint32_t> m_visited;
    std::uint32_t m_update = 0;
    // Until finish()
    std::vector<InternodeId> m_dirty;   ///< Internodes whose tubes must be meshed
    std::vector<InternodeId> m_waiting; ///< First internodes of such tubes, the last of them first
    std::vector<InternodeId> m_bare; ///< First internodes of tubes that wait for their leaves alone, likewise
    bool m_hasChanged = false;       ///< The tree, since collectWaiting()
    bool m_woodIsDirty = false;      ///< All tubes must be meshed
    bool m_leavesAreDirty = false;
};

} // namespace espalier

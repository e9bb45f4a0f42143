// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/LeafPlacer.h"
#include "model/mesh/WoodMesher.h"

#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Records which pieces of a growing tree's mesh (see WoodMesher), and which leaves, are out of date. Follows
/// the tree delta by delta, at a cost proportional to what the deltas touch. The caller keeps the meshes, and
/// reports what it has meshed.
///
/// A piece whose branches have only thickened counts as up to date until one of its radii is off by more than
/// kTolerance; noteInexact() finds such pieces, when there is time.
class WoodTracker {
public:
    static constexpr float kTolerance = 0.02F;

    explicit WoodTracker(const WoodMesher& mesher = tubeWood()) : m_mesher(&mesher) {}

    /// Starts again: all pieces of @p tree are to be meshed.
    void restart(const Tree& tree, const TreeIndex& index);
    bool isStarted() const { return m_widths.has_value(); }
    /// Notes what @p delta, which @p tree and @p index have just applied or reverted, and a change of the
    /// parameters put out of date. Call it for each delta.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    /// Notes the pieces that are within the tolerance but not exact; returns whether there are any.
    /// Precondition: isDone().
    bool noteInexact(const Tree& tree, const TreeIndex& index);
    /// Sets the fineness; a change puts all wood out of date.
    void setOptions(const WoodMeshOptions& options);
    /// Notes that all leaves are out of date.
    void noteLeavesMoved() { m_leavesAreDirty = true; }
    const WoodMeshOptions& options() const { return m_options; }

    /// Pieces by their first internodes.
    struct Work {
        /// Pieces that were meshed and do not exist any more, or will be meshed again.
        std::vector<InternodeId> gone;
        std::vector<InternodeId> wood;   ///< Pieces whose wood and leaves are to be meshed
        std::vector<InternodeId> leaves; ///< Pieces that only need new leaves
    };
    /// Takes the next pieces that are out of date: at most @p pieces of them, those that have waited longest
    /// first, and all pieces that are gone. They then count as up to date.
    Work take(const Tree& tree, const TreeIndex& index, std::size_t pieces);
    /// Whether there is nothing to take. Valid only if take() was called after the last follow().
    bool isDone() const { return m_waiting.empty() && m_bare.empty(); }

    /// The mesher of one thread, for the pieces that take() returned.
    std::unique_ptr<WoodPieceMesher> pieceMesher(const Tree& tree, const TreeIndex& index) const;
    /// Records the radii that the piece prepared by @p piece was meshed with. Several threads can call this
    /// at the same time, each for other pieces.
    void noteMeshed(const WoodPieceMesher& piece);
    /// Records which of these internodes have leaves now. Several threads can call this at the same time,
    /// each for other internodes.
    void noteLeaves(const LeafRule& rule, std::span<const InternodeId> internodes);
    /// The placed leaves of the tree. Precondition: isStarted().
    const PlacedLeafIndex& placedLeaves() const { return m_placedLeaves; }
    /// The widths that pieces are meshed with. Precondition: isStarted().
    const Widths& widths() const { return *m_widths; }
    /// The internodes of the piece that begins with @p base, parents before children.
    std::vector<InternodeId> internodesOf(const TreeIndex& index, InternodeId base) const;

    /// The radius that an internode was meshed with, and that of the internode below a piece's base, m.
    float meshedRadius(InternodeId id) const { return m_radius[id]; }
    float supportRadius(InternodeId base) const { return m_supportRadius[base]; }
    std::size_t bytes() const;

private:
    void forgetRemoved(const Tree& tree, const TreeDelta& delta);
    void collectTouched(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    void collectChanged(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    void collectRange(const Tree& tree, const TreeIndex& index, IdRange range, float tolerance);
    void inspect(const TreeIndex& index, InternodeId id, float tolerance);
    void checkRadius(const TreeIndex& index, InternodeId id, float tolerance);
    void resize(std::uint32_t size);
    void startRound();
    void followWidths(const Tree& tree, const TreeIndex& index);
    void forget(InternodeId id);
    void collectWaiting(const Tree& tree);
    InternodeId newPieceOf(const Tree& tree, InternodeId id);

    const WoodMesher* m_mesher;
    WoodMeshOptions m_options;
    TreeParameters m_parameters;
    PlacedLeafIndex m_placedLeaves;
    std::optional<Widths> m_widths;
    bool m_widthsAreStale = false; ///< Used only where radii depend, or did depend, on more than tips
    // Power of the widths when this round of checks began, and when the one before began: every radius has
    // been checked since the earlier one.
    double m_roundPower = 0.0;
    double m_checkedPower = 0.0;
    InternodeId m_nextCheck = 0;

    // All of these have an element for each internode.
    std::vector<std::uint8_t> m_joins;   ///< Whether it belongs to the piece of its parent, when last checked
    std::vector<std::uint8_t> m_isPiece; ///< Whether it begins a piece that is meshed
    std::vector<float> m_supportRadius; ///< Support radius as meshed, m; 0 for internodes that begin no piece
    std::vector<float> m_radius;        ///< Radius as meshed, m
    std::vector<std::uint8_t> m_bears;  ///< Whether it has leaves, as placed
    std::vector<std::uint32_t> m_inspected; ///< Number of the update in which it was last checked
    std::vector<std::uint32_t> m_visited;
    std::uint32_t m_update = 0;
    // What take() still has to return.
    std::vector<InternodeId> m_gone;        ///< Pieces that are gone
    std::vector<InternodeId> m_dirty;       ///< Internodes whose pieces must be meshed
    std::vector<InternodeId> m_dirtyLeaves; ///< Internodes whose pieces need new leaves
    /// First internodes of the pieces to be meshed; the last one is the next.
    std::vector<InternodeId> m_waiting;
    /// First internodes of the pieces that only need leaves; the last one is the next.
    std::vector<InternodeId> m_bare;
    std::vector<InternodeId> m_joined; ///< Scratch of inspect()
    bool m_hasChanged = false;         ///< The tree has changed since collectWaiting()
    bool m_woodIsDirty = false;        ///< All pieces must be meshed
    bool m_leavesAreDirty = false;
};

} // namespace espalier

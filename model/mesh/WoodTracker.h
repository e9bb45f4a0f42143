// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/LeafPlacer.h"
#include "model/mesh/WoodMesher.h"

#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Knows which pieces of a growing tree's mesh (see WoodMesher), and which leaves, are out of date. Follows
/// the tree delta by delta, at a cost of what the deltas touch, and is told what was meshed; where meshes are
/// kept is the caller's business.
///
/// A piece whose branches have only thickened is in order until one of its radii is off by more than
/// kTolerance; noteInexact() finds these, when there is time.
class WoodTracker {
public:
    static constexpr float kTolerance = 0.02F;

    explicit WoodTracker(const WoodMesher& mesher = tubeWood()) : m_mesher(&mesher) {}

    /// Starts anew: nothing is meshed, and all of @p tree is to be.
    void restart(const Tree& tree, const TreeIndex& index);
    bool isStarted() const { return m_widths.has_value(); }
    /// Notes what @p delta, which @p tree and @p index have just applied or reverted, and other parameters in
    /// force make out of date. To be called for each delta.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    /// Notes what is within the tolerance but not exact; returns whether there is any. Precondition:
    /// isDone().
    bool noteInexact(const Tree& tree, const TreeIndex& index);
    /// Another fineness puts all wood out of date.
    void setOptions(const WoodMeshOptions& options);
    const WoodMeshOptions& options() const { return m_options; }

    /// Pieces by their first internodes.
    struct Work {
        std::vector<InternodeId> gone;   ///< Were meshed and are no pieces any more, or will be meshed anew
        std::vector<InternodeId> wood;   ///< To be meshed, leaves too
        std::vector<InternodeId> leaves; ///< To get new leaves alone
    };
    /// Takes the next pieces that are out of date, @p pieces of them at most, those that have waited longest
    /// first; what is gone comes all at once. They count as done.
    Work take(const Tree& tree, const TreeIndex& index, std::size_t pieces);
    /// Whether nothing is left to take. Not before take() has been called after the last follow().
    bool isDone() const { return m_waiting.empty() && m_bare.empty(); }

    /// The mesher of one thread, for the pieces that take() returned.
    std::unique_ptr<WoodPieceMesher> pieceMesher(const Tree& tree, const TreeIndex& index) const;
    /// Remembers what the piece that @p piece has prepared was meshed with. Threads may do so at the same
    /// time, each for pieces of its own.
    void noteMeshed(const WoodPieceMesher& piece);
    /// Remembers which of these internodes have been given leaves, likewise.
    void noteLeaves(const LeafPlacer& placer, std::span<const InternodeId> internodes);
    /// The internodes of the piece that begins with @p base, parents before children.
    std::vector<InternodeId> internodesOf(const TreeIndex& index, InternodeId base) const;

    /// The radius that an internode was meshed with, and that of the internode below a piece's base, m.
    float meshedRadius(InternodeId id) const { return m_radius[id]; }
    float supportRadius(InternodeId base) const { return m_supportRadius[base]; }
    std::size_t bytes() const;

private:
    void forgetRemoved(const Tree& tree, const TreeDelta& delta);
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

    const WoodMesher* m_mesher;
    WoodMeshOptions m_options;
    TreeParameters m_parameters;
    std::optional<Widths> m_widths;
    bool m_widthsAreStale = false; ///< Only where not tips alone decide, or did not
    // Power of the widths when this round of checks began, and the one before: every radius has been looked
    // at since that one.
    double m_roundPower = 0.0;
    double m_checkedPower = 0.0;
    InternodeId m_nextCheck = 0;

    // By internode
    std::vector<std::uint8_t> m_joins;      ///< The piece of its parent, as seen last
    std::vector<std::uint8_t> m_isPiece;    ///< That is meshed
    std::vector<float> m_supportRadius;     ///< m, as meshed; 0 for those that begin no piece
    std::vector<float> m_radius;            ///< m, as meshed
    std::vector<std::uint8_t> m_bears;      ///< Leaves, as placed
    std::vector<std::uint32_t> m_inspected; ///< Number of the update in which it was
    std::vector<std::uint32_t> m_visited;
    std::uint32_t m_update = 0;
    // Until take()
    std::vector<InternodeId> m_gone;    ///< Pieces
    std::vector<InternodeId> m_dirty;   ///< Internodes whose pieces must be meshed
    std::vector<InternodeId> m_waiting; ///< First internodes of such pieces, the last of them first
    std::vector<InternodeId>
        m_bare;                 ///< First internodes of pieces that wait for their leaves alone, likewise
    bool m_hasChanged = false;  ///< The tree, since collectWaiting()
    bool m_woodIsDirty = false; ///< All pieces must be meshed
    bool m_leavesAreDirty = false;
};

} // namespace espalier

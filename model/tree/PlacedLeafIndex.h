// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

namespace espalier {

inline constexpr LeafId kNoLeaf = std::numeric_limits<LeafId>::max();

/// Which placed leaves each internode bears: their rows, the removed leaves included, and no matter whether
/// the internode lives. Follows the tree's deltas, forwards and backwards, at a cost in proportion to the
/// leaves that a delta changes and those beside them. Equal trees have equal indices. Memory is in proportion
/// to the number of placed leaves.
class PlacedLeafIndex {
public:
    PlacedLeafIndex() = default;
    explicit PlacedLeafIndex(const Tree& tree) { rebuild(tree); }

    void rebuild(const Tree& tree);
    /// Follows @p delta, which @p tree has just applied or reverted.
    void update(const Tree& tree, const TreeDelta& delta);

    bool isEmpty() const { return m_first.empty(); }
    /// The leaves of an internode by ascending id; kNoLeaf ends the list.
    LeafId first(InternodeId id) const
    {
        const auto found = m_first.find(id);
        return found != m_first.end() ? found->second : kNoLeaf;
    }
    LeafId next(LeafId leaf) const { return m_next[leaf]; }

    /// The internodes whose leaves the last update added, removed or changed, ascending. After a revert, some
    /// of them may be rows that are no longer in the tree.
    std::span<const InternodeId> recentlyChanged() const { return m_changed; }

    std::size_t bytes() const;

private:
    void link(LeafId leaf, InternodeId internode);
    void unlink(LeafId leaf);

    std::unordered_map<InternodeId, LeafId> m_first;
    std::vector<LeafId> m_next;
    std::vector<InternodeId> m_internode; ///< That each leaf is listed under
    std::vector<InternodeId> m_changed;
};

/// Whether a placed leaf is there to be seen: it is not removed, its internode lives, and the tree's
/// parameters show leaves.
bool isPlacedLeafShown(const Tree& tree, LeafId leaf);
/// The number of those leaves.
std::uint64_t placedLeafCount(const Tree& tree);

/// World position of the place on the tree's own nodes at which a placed leaf is attached, m.
Vec3 placedLeafBase(const Tree& tree, const TreeIndex& index, LeafId leaf);
/// World frame of a placed leaf: +Y along the midrib, +Z the upper side.
Rotation placedLeafFrame(const Tree& tree, const TreeIndex& index, LeafId leaf);
/// Grows @p bounds, m, by the blades of all shown placed leaves.
void extendByPlacedLeaves(Box3& bounds, const Tree& tree, const TreeIndex& index);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/AncestorSweep.h"
#include "model/tree/Tree.h"

#include <span>
#include <vector>

namespace espalier {

/// Data derived from a tree that most algorithms need: children, axes, world positions and frames, and sums
/// over subtrees. The index follows the tree's deltas, forwards and backwards. An update costs in proportion
/// to the touched internodes, their siblings and their ancestors; if the delta moves internodes, or takes
/// away the longest one, also one pass over the tree. Equal trees have equal indices, no matter which deltas
/// led to them.
class TreeIndex {
public:
    TreeIndex() = default;
    explicit TreeIndex(const Tree& tree) { rebuild(tree); }

    void rebuild(const Tree& tree);
    /// Follows @p delta, which @p tree has just applied or reverted. Precondition: after a revert, the delta
    /// has its rows.
    void update(const Tree& tree, const TreeDelta& delta);

    std::uint32_t size() const { return static_cast<std::uint32_t>(m_firstChild.size()); }

    /// The living children by ascending id; kNoInternode ends the list.
    InternodeId firstChild(InternodeId id) const { return m_firstChild[id]; }
    InternodeId nextSibling(InternodeId id) const { return m_nextSibling[id]; }
    /// The living internode that continues the axis, or kNoInternode.
    InternodeId mainChild(InternodeId id) const { return m_mainChild[id]; }
    /// The first internode of the axis that @p id is on. It serves as the axis's id; a root is the id of its
    /// trunk.
    InternodeId axis(InternodeId id) const { return m_axis[id]; }
    /// Whether the axis that @p id is on stands where a person put it: a drawn branch, or one from a bud that
    /// was added. Growth makes no adventitious buds.
    bool isPlacedByHand(const Tree& tree, InternodeId id) const
    {
        return budKind(tree.columns().slot[axis(id)]) == BudKind::Adventitious;
    }

    /// World position of the node, which is at the upper end, m.
    const Vec3& nodePosition(InternodeId id) const { return m_position[id]; }
    /// World position of the lower end, where the internode is attached to its parent, m.
    Vec3 basePosition(const Tree& tree, InternodeId id) const;
    /// World frame: +Y along the internode.
    const Rotation& rotation(InternodeId id) const { return m_rotation[id]; }
    Vec3 heading(InternodeId id) const { return m_rotation[id] * Vec3(Vec3::UnitY()); }

    /// Number of living internodes in the subtree of @p id, with itself; 0 if it is dead.
    std::uint32_t subtreeSize(InternodeId id) const { return m_sums[id].internodes; }
    /// Number of living twig tips (internodes without a living child) in that subtree; 0 if @p id is dead.
    std::uint32_t tipCount(InternodeId id) const { return m_sums[id].tips; }
    /// Number of living internodes of all roots together.
    std::uint32_t livingCount() const;
    /// The number of living twig tips that the root with the most of them carries.
    std::uint32_t greatestTipCount() const;
    /// Internodes without a parent, the dead included, ascending; 0 is the seedling.
    std::span<const InternodeId> roots() const { return m_roots; }
    /// The root that @p id descends from; @p id itself if it is a root.
    InternodeId rootOf(const Tree& tree, InternodeId id) const;

    /// The length of the longest internode, the dead included, m.
    float greatestLength() const { return m_greatestLength; }

    /// Ids whose subtreeSize or tipCount changed in the last update, descending.
    std::span<const InternodeId> recentlyChanged() const { return m_changed; }
    /// Ids, the dead included, that the last update moved to another place or turned, ascending.
    std::span<const InternodeId> recentlyMoved() const { return m_moved; }

    /// A box around the nodes of the living internodes whose rows the last update removed, m; empty if it
    /// removed none.
    const Box3& recentlyRemoved() const { return m_removed; }

    std::size_t bytes() const;

private:
    struct Sums {
        std::uint32_t internodes = 0;
        std::uint32_t tips = 0;
        bool operator==(const Sums&) const = default;
        Sums& operator+=(const Sums& other)
        {
            internodes += other.internodes;
            tips += other.tips;
            return *this;
        }
    };

    /// An internode that has begun to live, or has died.
    struct Relink {
        InternodeId parent;
        InternodeId id;
        auto operator<=>(const Relink&) const = default;
    };

    void appendRows(const Tree& tree);
    void removeRows(const Tree& tree, const TreeDelta& delta);
    void place(const Tree& tree, InternodeId id);
    void moveAll(const Tree& tree, const TreeDelta& delta);
    void linkAll(const Tree& tree);
    void relink(const Tree& tree, std::vector<Relink>& changes);
    void addLength(float length);
    void dropLength(float length);
    void changeLengths(const Tree& tree, const TreeDelta& delta);
    void findGreatestLength(const Tree& tree);
    void refreshOwn(const Tree& tree, InternodeId id);
    void sweep(const Tree& tree);

    std::vector<InternodeId> m_firstChild;
    std::vector<InternodeId> m_nextSibling;
    std::vector<InternodeId> m_mainChild;
    std::vector<InternodeId> m_axis;
    std::vector<InternodeId> m_roots;
    std::vector<Vec3> m_position;
    std::vector<Rotation> m_rotation;
    std::vector<Sums> m_sums;
    std::vector<std::uint8_t> m_own; ///< Bit 0: counted as living; bit 1: counted as a tip
    float m_greatestLength = 0.0F;
    std::uint32_t m_longest = 0; ///< Number of internodes of that length
    AncestorSweep<Sums> m_sweep; ///< Differences of m_sums, modulo 2^32
    std::vector<InternodeId> m_changed;
    std::vector<InternodeId> m_moved;
    Box3 m_removed;
    std::vector<std::uint8_t> m_moves; ///< Scratch of moveAll(): whether an internode moves
};

/// World position of an internode's node, m, and its world frame.
struct Placement {
    Vec3 node;
    Rotation rotation;
};
/// The placement of an internode with its lower end at @p base, the local frame @p local and @p length, m.
Placement placeOn(const Vec3& base, const Rotation& parentRotation, const Rotation& local, float length);

} // namespace espalier

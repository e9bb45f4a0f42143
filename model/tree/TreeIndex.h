// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/AncestorSweep.h"
#include "model/tree/Tree.h"

#include <span>
#include <vector>

namespace espalier {

/// What follows from a tree and is asked for all the time: who hangs on whom, where everything stands, how
/// much each internode carries. Updated by the same deltas as the tree, forwards and backwards, in proportion
/// to what they touch and its ancestors. Equal trees have equal indices, however they came about.
class TreeIndex {
public:
    TreeIndex() = default;
    explicit TreeIndex(const Tree& tree) { rebuild(tree); }

    void rebuild(const Tree& tree);
    /// Follows @p delta, which @p tree has just applied or reverted (then it has its rows).
    void update(const Tree& tree, const TreeDelta& delta);

    std::uint32_t size() const { return static_cast<std::uint32_t>(m_firstChild.size()); }

    /// Living children, by ascending id; kNoInternode ends the list.
    InternodeId firstChild(InternodeId id) const { return m_firstChild[id]; }
    InternodeId nextSibling(InternodeId id) const { return m_nextSibling[id]; }
    /// The living internode that continues the axis, or kNoInternode.
    InternodeId mainChild(InternodeId id) const { return m_mainChild[id]; }
    /// The first internode of the axis that @p id is on: the axis's name. 0 is the trunk.
    InternodeId axis(InternodeId id) const { return m_axis[id]; }

    /// World position of the node at the upper end, m; of the lower end, where it is attached to its parent.
    const Vec3& nodePosition(InternodeId id) const { return m_position[id]; }
    Vec3 basePosition(const Tree& tree, InternodeId id) const;
    /// World frame: +Y along the internode.
    const Rotation& rotation(InternodeId id) const { return m_rotation[id]; }
    Vec3 heading(InternodeId id) const { return m_rotation[id] * Vec3(Vec3::UnitY()); }

    /// Living internodes of the subtree that @p id carries, itself included; 0 for the dead.
    std::uint32_t subtreeSize(InternodeId id) const { return m_sums[id].internodes; }
    /// Living twig tips (internodes without a living child) of that subtree; 0 for the dead.
    std::uint32_t tipCount(InternodeId id) const { return m_sums[id].tips; }
    /// Of all roots together.
    std::uint32_t livingCount() const;
    /// Internodes without a parent, the dead included, ascending; 0 is the seedling.
    std::span<const InternodeId> roots() const { return m_roots; }
    /// The root that @p id stands on.
    InternodeId rootOf(const Tree& tree, InternodeId id) const;

    /// No internode is longer, m; after longer ones have gone it may be more than need be.
    float greatestLength() const { return m_greatestLength; }

    /// Ids whose subtreeSize or tipCount changed in the last update, descending.
    std::span<const InternodeId> recentlyChanged() const { return m_changed; }
    /// Ids, the dead included, that the last update moved to another place or turned, ascending.
    std::span<const InternodeId> recentlyMoved() const { return m_moved; }

    /// Holds the nodes of the living internodes whose rows the last update took out, m; empty if none went.
    const Box3& recentlyRemoved() const { return m_removed; }

    std::size_t bytes() const;

private:
    struct Sums {
        std::uint32_t internodes = 0;
        std::uint32_t tips = 0;
        bool operator==(const Sums&) const = default;
    };

    void appendRows(const Tree& tree);
    void removeRows(const Tree& tree, const TreeDelta& delta);
    void place(const Tree& tree, InternodeId id);
    void moveAll(const Tree& tree, const TreeDelta& delta);
    void link(const Tree& tree, InternodeId id);
    void unlink(const Tree& tree, InternodeId id);
    void unlinkFrom(InternodeId parent, InternodeId id);
    void refreshOwn(const Tree& tree, InternodeId id);

    std::vector<InternodeId> m_firstChild;
    std::vector<InternodeId> m_nextSibling;
    std::vector<InternodeId> m_mainChild;
    std::vector<InternodeId> m_axis;
    std::vector<InternodeId> m_roots;
    std::vector<Vec3> m_position;
    std::vector<Rotation> m_rotation;
    std::vector<Sums> m_sums;
    std::vector<std::uint8_t> m_own; ///< Bit 0: counted as living, bit 1: as a tip
    std::vector<Sums> m_pending;     ///< Differences on their way down, modulo 2^32
    float m_greatestLength = 0.0F;
    AncestorSweep m_sweep;
    std::vector<InternodeId> m_changed;
    std::vector<InternodeId> m_moved;
    Box3 m_removed;
    std::vector<std::uint8_t> m_moves; ///< Scratch
};

/// World frame and node position of an internode that stands on the given base with the given local row.
struct Placement {
    Vec3 node;
    Rotation rotation;
};
Placement placeOn(const Vec3& base, const Rotation& parentRotation, const Rotation& local, float length);

} // namespace espalier

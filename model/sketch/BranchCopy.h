// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace espalier {

/// Where a copy of a branch begins, and how large it is.
struct CopyPlace {
    InternodeId parent = 0; ///< A living internode of the tree, or one that the same BranchCopies have made
    float along = 1.0F;     ///< On the parent: 0 at its lower end, 1 at its node
    Rotation rotation = Rotation::Identity(); ///< Of the copy's first internode in its parent's frame
    double scale = 1.0;                       ///< Of lengths and diameters, > 0
};

/// Copies of branches, many of them in one delta (Okabe 2005, 3.4 and 3.6). A copy has all living internodes
/// of the branch and their living placed leaves, with the same places on each other, rotations, buds, vigour
/// and parameter sets, profiles and twists. Lengths of internodes and leaves and the diameters that the user
/// has set are scaled, within the limits of TreeTables.h; vigour that was added and is not used yet is not
/// copied. All copies are of the tree before the delta.
///
/// A copy is a lateral branch: it has the bud slot of the original if that is free at the parent's node, or
/// else the first free one; a node whose slots are all taken has several branches in the last one.
class BranchCopies {
public:
    /// The most internodes of one delta.
    static constexpr std::uint32_t kMost = 1'000'000;

    /// Precondition: @p tree and @p index, its index, outlive this object.
    BranchCopies(const Tree& tree, const TreeIndex& index);

    /// Adds a copy of @p branch, a living internode with all that it carries; returns the id of the copy's
    /// first internode. Internodes beyond kMost are left out (finish() fails).
    InternodeId add(InternodeId branch, const CopyPlace& place);
    /// Adds a copy of a living placed leaf, on @p internode as in CopyPlace::parent. @p rotation: in the
    /// internode's frame. @p scale: of its length, > 0.
    void addLeaf(LeafId leaf, InternodeId internode, float along, const Rotation& rotation, double scale);
    /// Removes a living internode of the tree with all that it carries; twice is as good as once.
    void remove(InternodeId branch);
    /// Removes a living placed leaf of the tree. Call it once for each.
    void removeLeaf(LeafId leaf);
    bool isRemoved(InternodeId id) const { return !m_removed.empty() && m_removed[id]; }

    /// The living placed leaves of an internode of the tree, by ascending id.
    std::span<const std::pair<InternodeId, LeafId>> leavesOf(InternodeId id) const;

    /// The delta: a step of time, empty if nothing was added or removed. Fails (Kind::Input) if there are
    /// more than kMost new internodes or if a node lies farther away than kFarthestNode. Call it once.
    Result<TreeDelta> finish();

private:
    struct Part {
        InternodeId source;
        std::uint32_t parent;  ///< Index of the part that carries it
        std::uint32_t repeats; ///< Number of parts before it with the same parent and slot
    };
    struct Siblings {
        BudMask taken = 0;        ///< Slots that have a bud or a living branch
        std::uint32_t copies = 0; ///< That begin here
    };

    const std::vector<Part>& partsOf(InternodeId branch);
    Siblings& siblingsAt(InternodeId parent);
    std::uint8_t takeSlot(Siblings& siblings, InternodeId branch) const;
    void addRow(const Part& part, const CopyPlace& place, std::uint8_t slot, InternodeKey key);
    void copySparse(InternodeId source, InternodeId id, double scale);
    TreeRows& rows();
    bool isNew(InternodeId id) const { return id >= m_tree.size(); }

    const Tree& m_tree;
    const TreeIndex& m_index;
    TreeDelta m_delta;
    std::vector<std::pair<InternodeId, LeafId>> m_leaves; ///< The living ones, sorted
    std::unordered_map<InternodeId, std::vector<Part>> m_parts;
    std::unordered_map<InternodeId, Siblings> m_siblings;
    std::vector<Placement> m_places; ///< Of the new internodes
    std::vector<BudMask> m_slots;    ///< Of the new internodes: where they have branches
    std::vector<bool> m_removed;     ///< By internode of the tree; empty if none is
    bool m_isFar = false;
    bool m_isFull = false;
};

/// What BranchCopies::finish() says of too many internodes.
Error tooManyCopies();

} // namespace espalier

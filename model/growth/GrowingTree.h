// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Buds.h"
#include "model/growth/StampedColumn.h"
#include "model/growth/VoxelSpace.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

namespace espalier {

/// Memory that growth steps on the same tree reuse.
struct GrowthWorkspace {
    StampedColumn<double> vigour;
    StampedColumn<BudStates> buds;
    StampedColumn<std::uint8_t> marks;
    std::vector<BudAngles> budAngles; ///< By parameter set
};

/// A tree with what the growth step at hand adds to it, as the delta it will become: the tree itself is not
/// touched. Ids from tree.size() on are the new internodes'.
class GrowingTree {
public:
    GrowingTree(const Tree& tree, const TreeIndex& index, GrowthWorkspace& workspace);

    const Tree& tree() const { return m_tree; }
    const TreeIndex& index() const { return m_index; }
    std::uint32_t size() const { return m_tree.size() + static_cast<std::uint32_t>(m_positions.size()); }
    bool isNew(InternodeId id) const { return id >= m_tree.size(); }

    InternodeId parent(InternodeId id) const
    {
        return isNew(id) ? rows().parent[id - m_tree.size()] : m_tree.parent(id);
    }
    int slot(InternodeId id) const
    {
        return isNew(id) ? rows().slot[id - m_tree.size()] : m_tree.columns().slot[id];
    }
    const Vec3& nodePosition(InternodeId id) const
    {
        return isNew(id) ? m_positions[id - m_tree.size()] : m_index.nodePosition(id);
    }
    const Rotation& rotation(InternodeId id) const
    {
        return isNew(id) ? m_rotations[id - m_tree.size()] : m_index.rotation(id);
    }
    InternodeKey key(InternodeId id) const
    {
        return isNew(id) ? rows().key[id - m_tree.size()] : m_tree.key(id);
    }
    Vec3 heading(InternodeId id) const { return rotation(id) * Vec3(Vec3::UnitY()); }
    /// Its active buds.
    BudMask buds(InternodeId id) const { return budStates(id).active(); }
    BudStates budStates(InternodeId id) const
    {
        if (isNew(id))
            return rows().buds[id - m_tree.size()];
        return m_workspace.buds.has(id) ? m_workspace.buds[id] : m_tree.budStates(id);
    }
    InternodeId axis(InternodeId id) const
    {
        return isNew(id) ? m_axes[id - m_tree.size()] : m_index.axis(id);
    }
    const GrowthParameters& grownWith(InternodeId id) const
    {
        return isNew(id) ? m_tree.parameters().growth : m_tree.parametersOf(id).growth;
    }

    /// World direction of the bud @p slot at a node.
    Vec3 budDirection(InternodeId id, int slot) const
    {
        const std::size_t set = isNew(id) ? m_tree.currentParameterSet() : m_tree.columns().parameterSet[id];
        return rotation(id) * m_workspace.budAngles[set].direction(key(id), slot);
    }

    /// The voxels of @p space, each once, that new nodes lie in.
    std::vector<Cell> newCells(const VoxelSpace& space) const;

    /// Lets the bud @p slot at @p parent become an internode along the unit vector @p direction and returns
    /// its id.
    /// @param roll rad, of the new frame about the direction, against the parent's frame brought over the
    /// shortest way
    InternodeId grow(InternodeId parent, int slot, const Vec3& direction, double roll, double length,
                     double vigour);
    void kill(InternodeId id) { m_delta.died.push_back(id); }

    /// The delta of it all, one growth step long, or an empty one if nothing has changed.
    TreeDelta takeDelta();

private:
    const InternodeColumns& rows() const { return m_rows->internodes; }
    InternodeColumns& rows() { return m_rows->internodes; }

    const Tree& m_tree;
    const TreeIndex& m_index;
    GrowthWorkspace& m_workspace;
    TreeDelta m_delta;
    std::shared_ptr<TreeRows> m_rows;
    std::vector<Vec3> m_positions;
    std::vector<Rotation> m_rotations;
    std::vector<InternodeId> m_axes;
    std::vector<InternodeId> m_changedBuds;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Buds.h"
#include "model/growth/StampedColumn.h"
#include "model/growth/VoxelSpace.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

namespace espalier {

/// Memory that is reused by growth steps of the same tree.
struct GrowthWorkspace {
    StampedColumn<double> vigour;
    StampedColumn<BudStates> buds;
    StampedColumn<std::uint8_t> marks;
    StampedColumn<float> lengths;
    std::vector<BudAngles> budAngles; ///< By index of the parameter set
};

/// A tree together with the additions of the present growth step, which become a delta. The tree itself does
/// not change. Ids from tree.size() on are new internodes.
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
    float length(InternodeId id) const
    {
        if (isNew(id))
            return rows().length[id - m_tree.size()];
        return m_workspace.lengths.has(id) ? m_workspace.lengths[id] : m_tree.length(id);
    }
    /// The position of the node, m, after stretch().
    Vec3 stretchedPosition(InternodeId id) const
    {
        return nodePosition(id) + (isNew(id) ? 0.0F : length(id) - m_tree.length(id)) * heading(id);
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
    /// The active buds at its node.
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
    const TreeParameters& grownWith(InternodeId id) const
    {
        return isNew(id) ? m_tree.parameters() : m_tree.parametersOf(id);
    }

    /// World direction of the bud @p slot at a node.
    Vec3 budDirection(InternodeId id, int slot) const
    {
        const std::size_t set = isNew(id) ? m_tree.currentParameterSet() : m_tree.columns().parameterSet[id];
        return rotation(id) * m_workspace.budAngles[set].direction(key(id), slot);
    }

    /// The voxels of @p space that contain new nodes, each once, sorted.
    std::vector<Cell> newCells(const VoxelSpace& space) const;

    /// Makes an internode from the bud @p slot at @p parent, along the unit vector @p direction; returns its
    /// id. @p length in m, @p vigour relative to the strongest of the step, 0...1.
    /// @param roll rad; rotation of the new frame about the direction, relative to the parent's frame turned
    /// the shortest way to that direction
    InternodeId grow(InternodeId parent, int slot, const Vec3& direction, double roll, double length,
                     double vigour);
    /// Gives an internode of the tree that carries no others another length, m. nodePosition() stays that of
    /// the beginning of the step.
    void stretch(InternodeId id, float length);
    /// Gives an internode of the tree another local frame; nodePosition() and rotation() stay those of the
    /// beginning of the step. At most once for each internode.
    void turn(InternodeId id, const Rotation& local);
    /// Sets the added vigour of an internode, years; 0 is none. At most once for each internode.
    void setAddedVigour(InternodeId id, float years);
    /// Sets how far from its base on the axis that begins with @p axis is drawn, m. At most once for each
    /// axis.
    void setDrawnLength(InternodeId axis, float length);
    /// Lets an internode of the tree die in this step; the caller kills all that it carries as well.
    void kill(InternodeId id) { m_delta.died.push_back(id); }

    /// The delta of all additions, one growth step long; an empty one if there are none. To be called once.
    TreeDelta takeDelta();

private:
    /// The buds of a new internode of @p length, m: all are active, but the laterals rest where the axis is
    /// kept clear.
    BudStates budsOfNew(InternodeId parent, int slot, double length) const;
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
    std::vector<InternodeId> m_stretched;
};

} // namespace espalier

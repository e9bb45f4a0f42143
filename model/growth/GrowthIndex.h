// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Gravimorphism.h"
#include "model/growth/VoxelSpace.h"
#include "model/tree/AncestorSweep.h"
#include "model/tree/TreeIndex.h"

#include <span>
#include <vector>

namespace espalier {

/// What SelfOrganisingModel derives from a tree: which nodes are near a point, the light at a point, and the
/// sum of Q over all buds that an internode carries. It follows the tree's deltas, forwards and backwards.
/// All sums are of integers, so that equal trees have equal indices, no matter which deltas led to them.
class GrowthIndex {
public:
    /// Q = 1 in the integer unit of the sums.
    static constexpr double kUnit = 1 << 24;

    GrowthIndex() = default;
    GrowthIndex(const Tree& tree, const TreeIndex& index) { rebuild(tree, index); }

    void rebuild(const Tree& tree, const TreeIndex& index);
    /// Notes the internodes that @p delta changes; @p tree and @p index have just applied or reverted it. To
    /// be called for each delta, and settle() before the next query: so a change is processed once, even if
    /// many deltas touch the same internodes. Precondition: after a revert, the delta has its rows.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    /// Brings the index up to date.
    void settle(const Tree& tree, const TreeIndex& index);
    /// Processes about @p nodes of the noted internodes; returns whether the index is up to date.
    bool settleSome(const Tree& tree, const TreeIndex& index, std::size_t nodes);

    const VoxelSpace& space() const { return m_space; }

    /// Light L at a point (m), 0...1, by trilinear interpolation between voxels.
    float light(const Vec3& position) const { return m_space.lightAt(position); }

    /// Sum of Q = b L^κ (TreeSketch §3.2), in units of 1 / kUnit, over the living buds at the node of @p id
    /// and above it: the flow down through the internode; 0 if it is dead.
    std::int64_t basipetal(InternodeId id) const { return m_basipetal[id]; }
    /// The part that comes from the node's own terminal bud; 0 if there is none.
    std::int64_t terminalQ(const Tree& tree, InternodeId id) const
    {
        return (tree.buds(id) & kTerminalBud) != 0 ? m_sensed[id] : 0;
    }
    /// The part that comes from the node's living lateral bud @p slot.
    std::int64_t lateralQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const;

    std::size_t bytes() const;

private:
    /// The parameters that the sums depend on.
    struct Settings {
        float edge = 0.0F;
        ShadowPyramid pyramid;
        double lightSensitivity = 1.0;
        GravimorphismEllipse ellipse;
        bool operator==(const Settings&) const = default;
    };
    /// Makes the index with voxels of this edge, m; returns false if there would be too many voxels.
    bool fill(const Tree& tree, const TreeIndex& index, float edge);
    static Settings settingsOf(const GrowthParameters& parameters);

    std::int32_t sensedLight(std::uint32_t shadow) const;
    std::int32_t budQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const;
    void refresh(const Tree& tree, const TreeIndex& index, InternodeId id);
    void resize(std::uint32_t size);
    void removeRows(const Tree& tree, const TreeDelta& delta);
    void castAndSweep(const Tree& tree, const TreeIndex& index);

    static constexpr VoxelSpace::Place kNowhere = ~VoxelSpace::Place{0};

    Settings m_settings;
    VoxelSpace m_space;
    std::vector<VoxelSpace::Place> m_place;
    std::vector<bool> m_isNoted;
    std::vector<InternodeId> m_noted;   ///< Changed since settle(); some may have been removed since
    bool m_hasRemovedRows = false;      ///< Rows were removed since settle()
    std::vector<std::int32_t> m_sensed; ///< L^κ at the node, in units of 1 / kUnit
    std::vector<std::int32_t> m_own;    ///< Sum of Q over the node's own buds
    std::vector<std::int64_t> m_basipetal;
    AncestorSweep<std::int64_t> m_sweep; ///< Differences of m_basipetal
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Gravimorphism.h"
#include "model/growth/VoxelSpace.h"
#include "model/tree/AncestorSweep.h"
#include "model/tree/TreeIndex.h"

#include <span>
#include <vector>

namespace espalier {

/// What growth asks of a tree: which buds are near a point, how much light falls there, and how much of it
/// all that an internode carries receives. Follows the tree's deltas, forwards and backwards; all sums are of
/// integers, so that equal trees have equal indices, however they came about.
class GrowthIndex {
public:
    /// Q = 1 in the integer unit of the sums.
    static constexpr double kUnit = 1 << 24;

    GrowthIndex() = default;
    GrowthIndex(const Tree& tree, const TreeIndex& index) { rebuild(tree, index); }

    void rebuild(const Tree& tree, const TreeIndex& index);
    /// Notes what @p delta, which @p tree and @p index have just applied or reverted, has changed. To be
    /// called for each delta, and settle() before the next question: what many deltas change is worked out
    /// once.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    void settle(const Tree& tree, const TreeIndex& index);
    /// Works out a part of it, about so many nodes; returns whether nothing is left.
    bool settleSome(const Tree& tree, const TreeIndex& index, std::size_t nodes);

    const VoxelSpace& space() const { return m_space; }

    /// Light L at a point, 0...1: trilinear between voxels.
    float light(const Vec3& position) const { return m_space.lightAt(position); }

    /// Q = b L^κ (TreeSketch §3.2), in units of 1 / kUnit, of all living buds at the node of @p id and above:
    /// what flows down through the internode; 0 for the dead.
    std::int64_t basipetal(InternodeId id) const { return m_basipetal[id]; }
    /// The part of it that comes from the node's own terminal bud; 0 if there is none.
    std::int64_t terminalQ(const Tree& tree, InternodeId id) const
    {
        return (tree.buds(id) & kTerminalBud) != 0 ? m_sensed[id] : 0;
    }
    /// The part of it that comes from the node's living lateral bud @p slot.
    std::int64_t lateralQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const;

    std::size_t bytes() const;

private:
    /// What of the parameters the sums depend on.
    struct Settings {
        float edge = 0.0F;
        ShadowPyramid pyramid;
        double lightSensitivity = 1.0;
        GravimorphismEllipse ellipse;
        bool operator==(const Settings&) const = default;
    };
    /// False if voxels of that edge are too many.
    bool fill(const Tree& tree, const TreeIndex& index, float edge);
    static Settings settingsOf(const GrowthParameters& parameters);

    std::int32_t sensedLight(std::uint32_t shadow) const;
    std::int32_t budQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const;
    void refresh(const Tree& tree, const TreeIndex& index, InternodeId id);
    void removeRows(const Tree& tree, const TreeDelta& delta);
    void castAndSweep(const Tree& tree, const TreeIndex& index);

    static constexpr VoxelSpace::Place kNowhere = ~VoxelSpace::Place{0};

    Settings m_settings;
    VoxelSpace m_space;
    std::vector<VoxelSpace::Place> m_place;
    std::vector<std::uint8_t> m_isNoted;
    std::vector<InternodeId> m_noted;   ///< Until settle(); some may have gone since
    bool m_hasRemovedRows = false;      ///< Since settle()
    std::vector<std::int32_t> m_sensed; ///< L^κ at the node
    std::vector<std::int32_t> m_own;    ///< Sum over the node's own buds
    std::vector<std::int64_t> m_basipetal;
    std::vector<std::int64_t> m_pending; ///< Differences on their way down
    AncestorSweep m_sweep;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BudGrid.h"
#include "model/growth/GrowingTree.h"

#include <limits>
#include <span>
#include <vector>

namespace espalier {

/// Markers of free space (TreeSketch §3.2), as columns.
struct MarkerSet {
    std::vector<Vec3> positions;
    std::vector<Step> born; ///< Growth step of the stroke that a marker appeared in

    std::size_t size() const { return positions.size(); }
    void clear();
    /// Keeps the markers for which @p keep(i), in their order.
    template <class Keep>
    void filter(Keep&& keep)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size(); ++i) {
            if (keep(i)) {
                positions[kept] = positions[i];
                born[kept] = born[i];
                ++kept;
            }
        }
        positions.resize(kept);
        born.resize(kept);
    }
};

/// Which buds compete for markers and may grow; all of them still clear the space around themselves
/// (selective growth, TreeSketch figure 9).
struct Competitors {
    /// Only this bud and what grows from it; kNoInternode lets all buds compete.
    InternodeId node = kNoInternode;
    int slot = kTerminalSlot;

    bool areAll() const { return node == kNoInternode; }
    bool operator==(const Competitors&) const = default;
};

/// How buds sense free space (TreeSketch figure 8B). Lengths in m.
struct Perception {
    float occupancy;    ///< r
    float reach;        ///< r + d
    float cosHalfAngle; ///< cos(ζ / 2), ζ being the full apex angle

    static Perception of(const GrowthParameters& parameters);
};

struct BudRef {
    InternodeId node;
    int slot;
    auto operator<=>(const BudRef&) const = default;
};

/// A bud that owns at least one marker.
struct EnabledBud {
    BudRef bud;
    Vec3 space; ///< E: the normalised sum of the unit vectors toward its markers
};

/// Whether @p bud is, or grows from, what @p competitors names.
bool competes(const GrowingTree& tree, const Competitors& competitors, BudRef bud);

/// The competition of buds for the markers of free space in one growth step (TreeSketch §3.2). A marker
/// belongs to the nearest competing bud whose volume of perception contains it, at equal distance to the one
/// that points at it best; markers within the occupancy radius of a living bud go. The result does not
/// depend on the number of threads nor on the order of nodes and markers.
class Competition {
public:
    /// The tree, its @p space (its nodes by voxel) and the markers outlive the competition.
    Competition(GrowingTree& tree, const VoxelSpace& space, const Perception& perception,
                const Competitors& competitors, MarkerSet& markers);

    /// Lets the markers that were appended since the last time take part, all of them at first.
    /// @param perceivers a bud for each that is likely to perceive it, which shortens the search; or nothing
    void admit(std::span<const BudRef> perceivers = {});
    /// A further round, after the tree has grown since the last: costs what is near the new nodes.
    void repeat();

    /// Takes away the markers that @p buds, sorted, own; for the end of a step: nothing may be asked of the
    /// competition any more.
    void dropOwned(std::span<const BudRef> buds);

    /// The buds on @p firstNode or later ones that own markers, by ascending node and slot.
    std::vector<EnabledBud> enabled(InternodeId firstNode = 0) const;
    /// Calls @p visit(bud) for the owner of each marker that has one.
    template <class Visit>
    void forEachOwner(Visit&& visit) const
    {
        for (const Claim& claim : m_claims) {
            if (claim.bud.node != kNoInternode)
                visit(claim.bud);
        }
    }

private:
    /// A bud's claim on a marker.
    struct Claim {
        BudRef bud{kNoInternode, 0};
        float squaredDistance = std::numeric_limits<float>::max(); ///< m²
        float along = 0.0F;                                        ///< Cosine times distance

        bool beats(const Claim& other) const;
    };
    /// Nodes around a marker and their distances, as columns.
    class Neighbours {
    public:
        void clear()
        {
            m_ids.clear();
            m_squaredDistances.clear();
        }
        void add(InternodeId id, float squaredDistance)
        {
            m_ids.push_back(id);
            m_squaredDistances.push_back(squaredDistance);
        }
        /// The least squared distance, or one beyond all.
        float nearest() const;
        /// Calls @p visit(id) for each node at that squared distance, and takes it out.
        template <class Visit>
        void take(float squaredDistance, Visit&& visit);

    private:
        std::vector<InternodeId> m_ids;
        std::vector<float> m_squaredDistances;
    };

    /// So far is looked at first, m.
    float nearRadius() const;
    BudGrid gridOf(std::span<const Resident> nodes) const;
    /// Adds the grid of the internodes that have come since the last time.
    void meetNewNodes();
    /// The nodes with buds that stood before the step and are within reach of the markers' box.
    BudGrid treeAroundMarkers() const;
    bool isOccupied(const BudGrid& grid, const Vec3& marker) const;
    /// Gives @p claim to the best bud in @p grid that beats it, of those at least the squared distance
    /// @p inner away.
    void contest(const BudGrid& grid, const Vec3& marker, float inner, Claim& claim,
                 Neighbours& neighbours) const;
    /// Likewise of the buds on one node.
    void contend(InternodeId node, const Vec3& marker, Claim& claim) const;
    void drop(std::size_t first, const std::vector<std::uint8_t>& isGone);

    GrowingTree& m_tree;
    const VoxelSpace& m_space;
    Perception m_perception;
    Competitors m_competitors;
    MarkerSet& m_markers;
    std::vector<Claim> m_claims;  ///< By marker
    std::vector<BudGrid> m_grids; ///< Of the tree before the step, then of each round's new nodes
    std::uint32_t m_met;          ///< Internodes that have competed
};

} // namespace espalier

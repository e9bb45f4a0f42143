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
    std::vector<Step> born; ///< Growth step, counted by the caller, in which a marker appeared

    std::size_t size() const { return positions.size(); }
    void clear();
    /// Keeps the markers i for which @p keep(i) returns true, in their order.
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

/// The buds that compete for markers and may grow. Other buds still remove the markers around themselves
/// (selective growth, TreeSketch figure 9).
struct Competitors {
    /// Node of the only bud that may grow, with its descendants; kNoInternode lets all buds compete.
    InternodeId node = kNoInternode;
    int slot = kTerminalSlot;

    bool areAll() const { return node == kNoInternode; }
    bool operator==(const Competitors&) const = default;
};

/// How buds perceive free space (TreeSketch figure 8B). Lengths in m.
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

/// Whether @p bud may grow: it is the bud that @p competitors names, or grows from it.
bool competes(const GrowingTree& tree, const Competitors& competitors, BudRef bud);

/// The competition of buds for the markers of free space in one growth step (TreeSketch §3.2). A marker
/// belongs to the nearest competing bud whose volume of perception contains it; at equal distance, to the bud
/// that points at it most directly. Markers within the occupancy radius of a living bud are removed. The
/// result does not depend on the number of threads nor on the order of nodes.
class Competition {
public:
    /// @p space has the tree's nodes by voxel. The tree, the space and the markers must outlive the
    /// competition.
    Competition(GrowingTree& tree, const VoxelSpace& space, const Perception& perception,
                const Competitors& competitors, MarkerSet& markers);

    /// Adds the markers that were appended since the last call (all, at the first call) to the competition.
    /// @param perceivers for each of them, a bud that probably perceives it, which shortens the search; or
    /// empty
    void admit(std::span<const BudRef> perceivers = {});
    /// Makes another round after the tree has grown. The cost depends on the markers and the new nodes.
    void repeat();

    /// Removes the markers that are owned by @p buds, which are sorted. To be called last: the competition is
    /// not valid afterwards.
    void dropOwned(std::span<const BudRef> buds);

    /// The buds at @p firstNode or later nodes that own markers, by ascending node and slot.
    std::vector<EnabledBud> enabled(InternodeId firstNode = 0) const;
    /// Calls @p visit(bud) for the owner of each marker that has an owner.
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
        /// The least squared distance, m²; infinity if no node is left.
        float nearest() const;
        /// Calls @p visit(id) for each node at exactly that squared distance, and removes these nodes.
        template <class Visit>
        void take(float squaredDistance, Visit&& visit);

    private:
        std::vector<InternodeId> m_ids;
        std::vector<float> m_squaredDistances;
    };

    /// Radius of the first, smaller search, m.
    float nearRadius() const;
    BudGrid gridOf(std::span<const GridNode> nodes) const;
    /// Adds a grid of the internodes that are new since the last call.
    void meetNewNodes();
    /// The nodes with buds that existed before the step and are within reach of the markers' bounding box.
    BudGrid treeAroundMarkers() const;
    bool isOccupied(const BudGrid& grid, const Vec3& marker) const;
    /// Replaces @p claim by that of the best bud in @p grid, if that beats it. Only nodes at the squared
    /// distance @p inner or farther are searched.
    void contest(const BudGrid& grid, const Vec3& marker, float inner, Claim& claim,
                 Neighbours& neighbours) const;
    /// The same for the buds of one node.
    void contend(InternodeId node, const Vec3& marker, Claim& claim) const;
    void drop(std::size_t first, const std::vector<std::uint8_t>& isGone);

    GrowingTree& m_tree;
    const VoxelSpace& m_space;
    Perception m_perception;
    Competitors m_competitors;
    MarkerSet& m_markers;
    std::vector<Claim> m_claims;  ///< By marker
    std::vector<BudGrid> m_grids; ///< One of the tree before the step, then one of each round's new nodes
    std::uint32_t m_met;          ///< Number of internodes that take part
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Competition.h"

#include "model/base/Parallel.h"
#include "model/growth/Buds.h"

#include <cmath>
#include <numeric>

namespace espalier {

namespace {

/// A node with living buds near the markers of one voxel.
struct Neighbour {
    Vec3 position;
    InternodeId id;
};

constexpr BudRef kNobody{kNoInternode, 0};
/// Owner of a marker that lies in an occupied zone.
constexpr BudRef kOccupied{kNoInternode, 1};

class Contest {
public:
    Contest(const GrowingTree& tree, const VoxelSpace& space, const Perception& perception,
            const Competitors& competitors)
        : m_tree(tree), m_space(space), m_perception(perception), m_competitors(competitors)
    {
    }

    /// Nodes with living buds that may reach into voxel @p cell.
    void gather(const Cell& cell, std::vector<Neighbour>& neighbours) const
    {
        neighbours.clear();
        gatherFrom(m_space, cell, 0, neighbours);
        gatherFrom(m_tree.newNodes(), cell, m_tree.tree().size(), neighbours);
    }

    /// Of a marker in no occupied zone.
    BudRef ownerOf(const Vec3& marker, const std::vector<Neighbour>& neighbours) const
    {
        float nearest = m_perception.reach * m_perception.reach;
        float bestAlignment = 0.0F;
        BudRef owner = kNobody;
        for (const Neighbour& neighbour : neighbours) {
            const Vec3 toMarker = marker - neighbour.position;
            const float squared = toMarker.squaredNorm();
            if (squared > nearest)
                continue;
            const float distance = std::sqrt(squared);
            for (unsigned rest = m_tree.buds(neighbour.id); rest != 0; rest &= rest - 1) {
                const BudRef bud{neighbour.id, std::countr_zero(rest)};
                const float alignment = directionOf(bud).dot(toMarker);
                if (alignment < m_perception.cosHalfAngle * distance)
                    continue;
                const bool better = squared < nearest || owner == kNobody || alignment > bestAlignment ||
                                    (alignment == bestAlignment && bud < owner);
                if (!better || !competes(m_tree, m_competitors, bud))
                    continue;
                nearest = squared;
                bestAlignment = alignment;
                owner = bud;
            }
        }
        return owner;
    }

    /// Whether any bud's occupied zone holds the marker.
    bool isOccupied(const Vec3& marker, const std::vector<Neighbour>& neighbours) const
    {
        const float occupied = m_perception.occupancy * m_perception.occupancy;
        return std::ranges::any_of(neighbours, [&](const Neighbour& neighbour) {
            return (marker - neighbour.position).squaredNorm() < occupied;
        });
    }

private:
    void gatherFrom(const VoxelSpace& space, const Cell& cell, InternodeId offset, std::vector<Neighbour>& neighbours) const
    {
        const int reach = static_cast<int>(std::ceil(m_perception.reach / space.edge()));
        const Vec3 centre = space.centreOf(cell);
        // Half a voxel's diagonal more than a bud perceives.
        const float limit = m_perception.reach + 0.8661F * space.edge();
        space.forEachOccupied({cell.x - reach, cell.y - reach, cell.z - reach},
                              {cell.x + reach, cell.y + reach, cell.z + reach}, [&](InternodeId first) {
                                  for (InternodeId node = first; node != kNoInternode; node = space.nextInCell(node)) {
                                      const InternodeId id = node + offset;
                                      const Vec3& position = m_tree.nodePosition(id);
                                      if (m_tree.buds(id) != 0 && (position - centre).squaredNorm() < limit * limit)
                                          neighbours.push_back({position, id});
                                  }
                              });
    }

    Vec3 directionOf(const BudRef& bud) const
    {
        return budDirection(m_tree.tree().seed(), bud.node, bud.slot, m_tree.rotation(bud.node),
                            m_tree.grownWith(bud.node));
    }

    const GrowingTree& m_tree;
    const VoxelSpace& m_space;
    const Perception& m_perception;
    const Competitors& m_competitors;
};

} // namespace

void MarkerSet::clear()
{
    positions.clear();
    born.clear();
}

Perception Perception::of(const GrowthParameters& p)
{
    return {static_cast<float>(p.occupancyRadius * p.internodeLength),
            static_cast<float>((p.occupancyRadius + p.perceptionDepth) * p.internodeLength),
            static_cast<float>(std::cos(p.perceptionAngle / 2.0))};
}

bool competes(const GrowingTree& tree, const Competitors& competitors, BudRef bud)
{
    if (competitors.node == kNoInternode || (bud.node == competitors.node && bud.slot == competitors.slot))
        return true;
    InternodeId id = bud.node;
    while (id > competitors.node) {
        const InternodeId parent = tree.parent(id);
        if (parent == competitors.node)
            return tree.slot(id) == competitors.slot;
        id = parent;
    }
    return false;
}

std::vector<EnabledBud> competeForSpace(const GrowingTree& tree, const VoxelSpace& space, const Perception& perception,
                                        const Competitors& competitors, MarkerSet& markers)
{
    const Contest contest(tree, space, perception, competitors);

    // Markers of the same voxel share the search for neighbours.
    std::vector<std::pair<Cell, std::uint32_t>> byCell(markers.size());
    for (std::uint32_t i = 0; i < markers.size(); ++i)
        byCell[i] = {space.cellAt(markers.positions[i]), i};
    std::ranges::sort(byCell);

    std::vector<BudRef> owners(markers.size(), kNobody);
    parallelFor(byCell.size(), 512, [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> neighbours;
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [cell, marker] = byCell[i];
            if (i == begin || cell != byCell[i - 1].first)
                contest.gather(cell, neighbours);
            const Vec3& position = markers.positions[marker];
            owners[marker] = contest.isOccupied(position, neighbours) ? kOccupied : contest.ownerOf(position, neighbours);
        }
    });

    std::vector<std::uint32_t> owned;
    for (std::uint32_t i = 0; i < owners.size(); ++i) {
        if (owners[i].node != kNoInternode)
            owned.push_back(i);
    }
    std::ranges::sort(owned, [&](std::uint32_t a, std::uint32_t b) {
        return owners[a] != owners[b] ? owners[a] < owners[b] : a < b;
    });

    std::vector<EnabledBud> enabled;
    for (std::size_t i = 0; i < owned.size();) {
        const BudRef bud = owners[owned[i]];
        Vec3 sum = Vec3::Zero();
        for (; i < owned.size() && owners[owned[i]] == bud; ++i)
            sum += (markers.positions[owned[i]] - tree.nodePosition(bud.node)).normalized();
        const float norm = sum.norm();
        enabled.push_back({bud, norm > 1e-6F ? Vec3(sum / norm) : Vec3(Vec3::Zero())});
    }
    markers.filter([&](std::size_t i) { return owners[i] != kOccupied; });
    return enabled;
}

} // namespace espalier

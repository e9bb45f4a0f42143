// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Competition.h"

#include "model/base/Parallel.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace espalier {

namespace {

/// Markers in the same block of 2³ voxels share the search for neighbours.
constexpr int kBlockBits = 1;
constexpr int kBlock = 1 << kBlockBits;

constexpr BudRef kNobody{kNoInternode, 0};

/// The nodes with living buds around the markers of one block, as columns; and their distances from the
/// marker at hand.
struct Neighbours {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> z;
    std::vector<InternodeId> ids;
    std::vector<std::int32_t>
        squaredDistances; ///< Bits of the floats: as integers, which compare alike, they make faster loops

    void clear()
    {
        x.clear();
        y.clear();
        z.clear();
        ids.clear();
    }
    void add(const Vec3& position, InternodeId id)
    {
        x.push_back(position.x());
        y.push_back(position.y());
        z.push_back(position.z());
        ids.push_back(id);
    }
    void measureFrom(const Vec3& point)
    {
        const std::size_t count = ids.size();
        squaredDistances.resize(count);
        const float px = point.x();
        const float py = point.y();
        const float pz = point.z();
        for (std::size_t i = 0; i < count; ++i) {
            const float dx = px - x[i];
            const float dy = py - y[i];
            const float dz = pz - z[i];
            squaredDistances[i] = std::bit_cast<std::int32_t>(dx * dx + dy * dy + dz * dz);
        }
    }
    std::int32_t nearest() const
    {
        std::int32_t least = kFar;
        for (const std::int32_t squared : squaredDistances)
            least = std::min(least, squared);
        return least;
    }

    static constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();
};

class Contest {
public:
    Contest(const GrowingTree& tree, const VoxelSpace& space, const Perception& perception,
            const Competitors& competitors)
        : m_tree(tree), m_space(space), m_perception(perception), m_competitors(competitors)
    {
    }

    bool isOccupied(const Vec3& marker) const
    {
        return isOccupied(m_space, 0, marker) || isOccupiedAnew(marker);
    }
    bool isOccupiedAnew(const Vec3& marker) const
    {
        return isOccupied(m_tree.newNodes(), m_tree.tree().size(), marker);
    }
    bool perceives(const BudRef& bud, const Vec3& marker) const
    {
        const Vec3 toMarker = marker - m_tree.nodePosition(bud.node);
        const float distance = toMarker.norm();
        return distance <= m_perception.reach &&
               m_tree.budDirection(bud.node, bud.slot).dot(toMarker) >= m_perception.cosHalfAngle * distance;
    }

    /// The block of kBlock³ voxels that a marker lies in.
    Cell blockOf(const Vec3& marker) const
    {
        const Cell cell = m_space.cellAt(marker);
        return {cell.x >> kBlockBits, cell.y >> kBlockBits, cell.z >> kBlockBits};
    }

    /// Nodes with living buds that may perceive something in @p block.
    void gather(const Cell& block, Neighbours& neighbours) const
    {
        neighbours.clear();
        gather(m_space, 0, block, neighbours);
        gather(m_tree.newNodes(), m_tree.tree().size(), block, neighbours);
    }

    /// Of a marker in no occupied zone.
    BudRef ownerOf(const Vec3& marker, Neighbours& neighbours) const
    {
        neighbours.measureFrom(marker);
        const auto limit = std::bit_cast<std::int32_t>(m_perception.reach * m_perception.reach);
        for (std::int32_t nearest = neighbours.nearest(); nearest <= limit; nearest = neighbours.nearest()) {
            BudRef owner = kNobody;
            float alignment = 0.0F;
            for (std::size_t i = 0; i < neighbours.ids.size(); ++i) {
                if (neighbours.squaredDistances[i] == nearest) {
                    neighbours.squaredDistances[i] = Neighbours::kFar;
                    contend(neighbours.ids[i], marker, owner, alignment);
                }
            }
            if (owner != kNobody)
                return owner;
        }
        return kNobody;
    }

private:
    /// Makes a bud of the node the marker's owner if one perceives it and points at it better than the owner
    /// so far.
    void contend(InternodeId id, const Vec3& marker, BudRef& owner, float& alignment) const
    {
        const Vec3 toMarker = marker - m_tree.nodePosition(id);
        const float least = m_perception.cosHalfAngle * toMarker.norm();
        for (unsigned rest = m_tree.buds(id); rest != 0; rest &= rest - 1) {
            const BudRef bud{id, std::countr_zero(rest)};
            const float along = m_tree.budDirection(id, bud.slot).dot(toMarker);
            if (along < least || !competes(m_tree, m_competitors, bud))
                continue;
            if (owner == kNobody || along > alignment || (along == alignment && bud < owner)) {
                owner = bud;
                alignment = along;
            }
        }
    }

    bool isOccupied(const VoxelSpace& space, InternodeId offset, const Vec3& marker) const
    {
        const float squaredRadius = m_perception.occupancy * m_perception.occupancy;
        const Vec3 reach = Vec3::Constant(m_perception.occupancy);
        return space.anyOccupied(
            space.cellAt(marker - reach), space.cellAt(marker + reach), [&](InternodeId first) {
                for (InternodeId node = first; node != kNoInternode; node = space.nextInCell(node)) {
                    if ((m_tree.nodePosition(node + offset) - marker).squaredNorm() < squaredRadius &&
                        m_tree.buds(node + offset) != 0)
                        return true;
                }
                return false;
            });
    }

    void gather(const VoxelSpace& space, InternodeId offset, const Cell& block, Neighbours& neighbours) const
    {
        const float half = 0.5F * static_cast<float>(kBlock) * m_space.edge();
        const Vec3 centre = 2.0F * half *
                            Vec3(static_cast<float>(block.x) + 0.5F, static_cast<float>(block.y) + 0.5F,
                                 static_cast<float>(block.z) + 0.5F);
        // Half a block's diagonal more than a bud perceives.
        const float limit = m_perception.reach + 1.7321F * half;
        const Vec3 reach = Vec3::Constant(m_perception.reach + half);
        space.anyOccupied(space.cellAt(centre - reach), space.cellAt(centre + reach), [&](InternodeId first) {
            for (InternodeId node = first; node != kNoInternode; node = space.nextInCell(node)) {
                const InternodeId id = node + offset;
                const Vec3& position = m_tree.nodePosition(id);
                if ((position - centre).squaredNorm() < limit * limit && m_tree.buds(id) != 0)
                    neighbours.add(position, id);
            }
            return false;
        });
    }

    const GrowingTree& m_tree;
    const VoxelSpace& m_space;
    const Perception& m_perception;
    const Competitors& m_competitors;
};

template <class IsGone>
void removeMarkers(MarkerSet& markers, IsGone&& isGone)
{
    std::vector<std::uint8_t> gone(markers.size());
    parallelFor(markers.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            gone[i] = isGone(markers.positions[i]) ? 1 : 0;
    });
    markers.filter([&](std::size_t i) { return gone[i] == 0; });
}

/// Finds the owners of the markers @p asked (indices) and what space these see.
std::vector<EnabledBud> distribute(const Contest& contest, const GrowingTree& tree, const MarkerSet& markers,
                                   const std::vector<std::uint32_t>& asked)
{
    std::vector<std::pair<Cell, std::uint32_t>> byBlock(asked.size());
    for (std::size_t i = 0; i < asked.size(); ++i)
        byBlock[i] = {contest.blockOf(markers.positions[asked[i]]), asked[i]};
    std::ranges::sort(byBlock);
    std::vector<std::pair<BudRef, std::uint32_t>> owned(asked.size()); // owner, marker
    parallelFor(byBlock.size(), 512, [&](std::size_t begin, std::size_t end) {
        Neighbours neighbours;
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [block, marker] = byBlock[i];
            if (i == begin || block != byBlock[i - 1].first)
                contest.gather(block, neighbours);
            owned[i] = {contest.ownerOf(markers.positions[marker], neighbours), marker};
        }
    });
    std::erase_if(owned, [](const auto& pair) { return pair.first == kNobody; });
    std::ranges::sort(owned);

    std::vector<EnabledBud> enabled;
    for (std::size_t i = 0; i < owned.size();) {
        const BudRef bud = owned[i].first;
        Vec3 sum = Vec3::Zero();
        for (; i < owned.size() && owned[i].first == bud; ++i)
            sum += (markers.positions[owned[i].second] - tree.nodePosition(bud.node)).normalized();
        const float norm = sum.norm();
        enabled.push_back({bud, norm > 1e-6F ? Vec3(sum / norm) : Vec3(Vec3::Zero())});
    }
    return enabled;
}

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

std::vector<EnabledBud> competeForSpace(const GrowingTree& tree, const VoxelSpace& space,
                                        const Perception& perception, const Competitors& competitors,
                                        MarkerSet& markers)
{
    const Contest contest(tree, space, perception, competitors);
    removeMarkers(markers, [&](const Vec3& marker) { return contest.isOccupied(marker); });
    std::vector<std::uint32_t> all(markers.size());
    std::iota(all.begin(), all.end(), 0U);
    return distribute(contest, tree, markers, all);
}

std::vector<EnabledBud> competeAgain(const GrowingTree& tree, const VoxelSpace& space,
                                     const Perception& perception, const Competitors& competitors,
                                     const std::vector<BudRef>& tips, MarkerSet& markers)
{
    const Contest contest(tree, space, perception, competitors);
    removeMarkers(markers, [&](const Vec3& marker) { return contest.isOccupiedAnew(marker); });

    // Only markers that a tip perceives can be its own.
    VoxelSpace tipSpace(perception.reach, {});
    for (std::uint32_t tip = 0; tip < tips.size(); ++tip)
        tipSpace.insert(tip, tree.nodePosition(tips[tip].node));
    const Vec3 reach = Vec3::Constant(perception.reach);
    std::vector<std::uint32_t> perceived;
    for (std::uint32_t i = 0; i < markers.size(); ++i) {
        const Vec3& marker = markers.positions[i];
        const bool isPerceived = tipSpace.anyOccupied(
            tipSpace.cellAt(marker - reach), tipSpace.cellAt(marker + reach), [&](std::uint32_t first) {
                for (std::uint32_t tip = first; tip != kNoInternode; tip = tipSpace.nextInCell(tip)) {
                    if (contest.perceives(tips[tip], marker))
                        return true;
                }
                return false;
            });
        if (isPerceived)
            perceived.push_back(i);
    }
    std::vector<EnabledBud> enabled = distribute(contest, tree, markers, perceived);
    std::erase_if(enabled, [&](const EnabledBud& bud) { return !std::ranges::binary_search(tips, bud.bud); });
    return enabled;
}

} // namespace espalier

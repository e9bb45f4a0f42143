// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Competition.h"

#include "model/base/Parallel.h"

#include <bit>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

/// Most markers have their owner within this share of the depth of perception, so that range is searched
/// first.
constexpr float kNearShare = 0.3F;

constexpr std::size_t kMarkersPerTask = 512;

constexpr float kBeyond = std::numeric_limits<float>::infinity();

} // namespace

float Competition::Neighbours::nearest() const
{
    // Non-negative floats compare like their bits as integers, and the loop over integers is faster.
    std::int32_t least = std::bit_cast<std::int32_t>(kBeyond);
    for (const float squared : m_squaredDistances)
        least = std::min(least, std::bit_cast<std::int32_t>(squared));
    return std::bit_cast<float>(least);
}

template <class Visit>
void Competition::Neighbours::take(float squaredDistance, Visit&& visit)
{
    for (std::size_t i = 0; i < m_ids.size(); ++i) {
        if (m_squaredDistances[i] == squaredDistance) {
            m_squaredDistances[i] = kBeyond;
            visit(m_ids[i]);
        }
    }
}

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
    while (id != kNoInternode && id > competitors.node) {
        const InternodeId parent = tree.parent(id);
        if (parent == competitors.node)
            return tree.slot(id) == competitors.slot;
        id = parent;
    }
    return false;
}

Competition::Competition(GrowingTree& tree, const VoxelSpace& space, const Perception& perception,
                         const Competitors& competitors, MarkerSet& markers)
    : m_tree(tree),
      m_space(space),
      m_perception(perception),
      m_competitors(competitors),
      m_markers(markers),
      m_met(tree.size())
{
}

void Competition::admit(std::span<const BudRef> perceivers)
{
    const std::size_t first = m_claims.size();
    m_claims.resize(m_markers.size());
    m_grids.assign(1, treeAroundMarkers());
    m_met = m_tree.tree().size();
    meetNewNodes();
    std::vector<std::uint8_t> isGone(m_claims.size() - first, 0);
    const std::vector<std::uint32_t> order =
        m_grids.front().orderOf(std::span(m_markers.positions).subspan(first));
    parallelFor(order.size(), kMarkersPerTask, [&](std::size_t begin, std::size_t end) {
        Neighbours neighbours;
        for (const std::uint32_t i : std::span(order).subspan(begin, end - begin)) {
            const Vec3& marker = m_markers.positions[first + i];
            isGone[i] =
                std::ranges::any_of(m_grids, [&](const BudGrid& grid) { return isOccupied(grid, marker); });
            if (isGone[i] != 0)
                continue;
            if (!perceivers.empty())
                contend(perceivers[i].node, marker, m_claims[first + i]);
            for (const BudGrid& grid : m_grids)
                contest(grid, marker, 0.0F, m_claims[first + i], neighbours);
        }
    });
    drop(first, isGone);
}

void Competition::repeat()
{
    meetNewNodes();
    std::vector<std::uint8_t> isGone(m_claims.size(), 0);
    const std::vector<std::uint32_t> order = m_grids.front().orderOf(m_markers.positions);
    parallelFor(order.size(), kMarkersPerTask, [&](std::size_t begin, std::size_t end) {
        Neighbours neighbours;
        for (const std::uint32_t i : std::span(order).subspan(begin, end - begin)) {
            const Vec3& marker = m_markers.positions[i];
            isGone[i] = isOccupied(m_grids.back(), marker) ? 1 : 0;
            if (isGone[i] != 0)
                continue;
            // Only new nodes add buds, and only shoots use them up. If the owner is used up, the remaining
            // buds of the older grids are at least as far away as it was.
            Claim& claim = m_claims[i];
            const Claim before = claim;
            if (before.bud.node == kNoInternode ||
                (m_tree.buds(before.bud.node) & budBit(before.bud.slot)) != 0) {
                contest(m_grids.back(), marker, 0.0F, claim, neighbours);
                continue;
            }
            claim = {};
            contest(m_grids.back(), marker, 0.0F, claim, neighbours);
            for (std::size_t grid = m_grids.size() - 1; grid-- > 0;)
                contest(m_grids[grid], marker, before.squaredDistance, claim, neighbours);
        }
    });
    drop(0, isGone);
}

void Competition::dropOwned(std::span<const BudRef> buds)
{
    m_markers.filter(
        [&](std::size_t i) { return !std::binary_search(buds.begin(), buds.end(), m_claims[i].bud); });
}

std::vector<EnabledBud> Competition::enabled(InternodeId firstNode) const
{
    std::vector<std::pair<BudRef, std::size_t>> owned; // owner, marker
    for (std::size_t i = 0; i < m_claims.size(); ++i) {
        const BudRef owner = m_claims[i].bud;
        if (owner.node != kNoInternode && owner.node >= firstNode)
            owned.emplace_back(owner, i);
    }
    std::ranges::sort(owned);

    std::vector<EnabledBud> enabled;
    for (std::size_t i = 0; i < owned.size();) {
        const BudRef bud = owned[i].first;
        Vec3 sum = Vec3::Zero();
        for (; i < owned.size() && owned[i].first == bud; ++i)
            sum += (m_markers.positions[owned[i].second] - m_tree.nodePosition(bud.node)).normalized();
        const float norm = sum.norm();
        enabled.push_back({bud, norm > 1e-6F ? Vec3(sum / norm) : Vec3(Vec3::Zero())});
    }
    return enabled;
}

void Competition::drop(std::size_t first, const std::vector<std::uint8_t>& isGone)
{
    const auto stays = [&](std::size_t i) { return i < first || isGone[i - first] == 0; };
    m_markers.filter(stays);
    std::size_t i = 0;
    std::erase_if(m_claims, [&](const Claim&) { return !stays(i++); });
}

float Competition::nearRadius() const
{
    return m_perception.occupancy + kNearShare * (m_perception.reach - m_perception.occupancy);
}

void Competition::meetNewNodes()
{
    std::vector<GridNode> nodes;
    for (; m_met < m_tree.size(); ++m_met) {
        const Vec3& position = m_tree.nodePosition(m_met);
        if (m_tree.buds(m_met) != 0)
            nodes.push_back({position.x(), position.y(), position.z(), m_met});
    }
    m_grids.push_back(gridOf(nodes));
}

BudGrid Competition::gridOf(std::span<const GridNode> nodes) const
{
    return {nodes, nearRadius()};
}

BudGrid Competition::treeAroundMarkers() const
{
    Box3 box;
    for (const Vec3& marker : m_markers.positions)
        box.extend(marker);
    std::vector<GridNode> nodes;
    if (!box.isEmpty())
        m_space.anyWithin(box, m_perception.reach, [&](VoxelSpace::Residents residents) {
            for (const InternodeId id : residents) {
                if (m_tree.buds(id) == 0)
                    continue;
                const Vec3& position = m_tree.nodePosition(id);
                nodes.push_back({position.x(), position.y(), position.z(), id});
            }
            return false;
        });
    return gridOf(nodes);
}

bool Competition::isOccupied(const BudGrid& grid, const Vec3& marker) const
{
    // Strictly nearer than the radius.
    const float outer = std::nextafter(m_perception.occupancy * m_perception.occupancy, 0.0F);
    return grid.anyNear(marker, 0.0F, outer, [](InternodeId, float) { return true; });
}

void Competition::contest(const BudGrid& grid, const Vec3& marker, float inner, Claim& claim,
                          Neighbours& neighbours) const
{
    if (grid.isEmpty())
        return;
    for (const float radius : {nearRadius(), m_perception.reach}) {
        const float outer = std::min(radius * radius, claim.squaredDistance);
        if (outer < inner)
            continue;
        neighbours.clear();
        grid.anyNear(marker, inner, outer, [&](InternodeId id, float squared) {
            neighbours.add(id, squared);
            return false;
        });
        for (float nearest = neighbours.nearest(); nearest <= claim.squaredDistance && nearest <= outer;
             nearest = neighbours.nearest())
            neighbours.take(nearest, [&](InternodeId id) { contend(id, marker, claim); });
        if (claim.squaredDistance <= outer)
            return;
        inner = outer;
    }
}

void Competition::contend(InternodeId node, const Vec3& marker, Claim& best) const
{
    const Vec3& position = m_tree.nodePosition(node);
    const Vec3 toMarker = marker - position;
    const float squaredDistance =
        GridNode{position.x(), position.y(), position.z(), node}.squaredDistance(marker);
    if (squaredDistance > m_perception.reach * m_perception.reach)
        return;
    const float least = m_perception.cosHalfAngle * toMarker.norm();
    for (unsigned rest = m_tree.buds(node); rest != 0; rest &= rest - 1) {
        const BudRef bud{node, std::countr_zero(rest)};
        const Claim claim{bud, squaredDistance, m_tree.budDirection(node, bud.slot).dot(toMarker)};
        if (claim.along >= least && claim.beats(best) && competes(m_tree, m_competitors, bud))
            best = claim;
    }
}

bool Competition::Claim::beats(const Claim& other) const
{
    if (squaredDistance != other.squaredDistance)
        return squaredDistance < other.squaredDistance;
    return along != other.along ? along > other.along : bud < other.bud;
}

} // namespace espalier

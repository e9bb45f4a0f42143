// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Competition.h"

#include "model/base/Parallel.h"

#include <bit>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

/// Most markers have their owner within this share of the depth of perception: so far is looked at first.
constexpr float kNearShare = 0.3F;

constexpr std::size_t kMarkersPerTask = 512;

constexpr float kBeyond = std::numeric_limits<float>::infinity();

} // namespace

void Competition::Neighbours::add(VoxelSpace::Residents residents, const Vec3& marker, float inner,
                                  float outer)
{
    if (m_ids.size() < m_count + residents.size()) {
        m_ids.resize(2 * m_count + residents.size());
        m_squaredDistances.resize(m_ids.size());
    }
    // Written anyway, kept if it counts: the loop has no branch.
    for (const Resident& resident : residents) {
        const float squared = resident.squaredDistance(marker);
        m_ids[m_count] = resident.id;
        m_squaredDistances[m_count] = squared;
        m_count += squared >= inner && squared <= outer ? 1 : 0;
    }
}

float Competition::Neighbours::nearest() const
{
    // As integers, which compare alike, the bits of floats make a faster loop.
    std::int32_t least = std::bit_cast<std::int32_t>(kBeyond);
    for (std::size_t i = 0; i < m_count; ++i)
        least = std::min(least, std::bit_cast<std::int32_t>(m_squaredDistances[i]));
    return std::bit_cast<float>(least);
}

template <class Visit>
void Competition::Neighbours::take(float squaredDistance, Visit&& visit)
{
    for (std::size_t i = 0; i < m_count; ++i) {
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
    while (id > competitors.node) {
        const InternodeId parent = tree.parent(id);
        if (parent == competitors.node)
            return tree.slot(id) == competitors.slot;
        id = parent;
    }
    return false;
}

Competition::Competition(GrowingTree& tree, const VoxelSpace& space, const Perception& perception,
                         const Competitors& competitors, MarkerSet& markers)
    : m_tree(tree), m_space(space), m_perception(perception), m_competitors(competitors), m_markers(markers)
{
}

void Competition::admit(std::span<const BudRef> perceivers)
{
    m_tree.settleNewNodes();
    const std::size_t first = m_claims.size();
    for (std::size_t i = first; i < m_markers.size(); ++i)
        m_claims.push_back({.bud = perceivers.empty() ? BudRef{kNoInternode, 0} : perceivers[i - first]});
    dropOccupied(first, [&](const Vec3& marker) {
        return isOccupied(m_space, 0, marker) || isOccupied(m_tree.newNodes(), m_tree.tree().size(), marker);
    });
    parallelFor(m_claims.size() - first, kMarkersPerTask, [&](std::size_t begin, std::size_t end) {
        Neighbours neighbours;
        for (std::size_t i = first + begin; i < first + end; ++i) {
            const Vec3& marker = m_markers.positions[i];
            const Claim likely = std::exchange(m_claims[i], {});
            if (likely.bud.node != kNoInternode)
                contend(likely.bud.node, marker, m_claims[i]);
            contest(m_space, 0, marker, 0.0F, m_claims[i], neighbours);
            contest(m_tree.newNodes(), m_tree.tree().size(), marker, 0.0F, m_claims[i], neighbours);
        }
    });
}

void Competition::repeat()
{
    m_tree.settleNewNodes();
    dropOccupied(
        0, [&](const Vec3& marker) { return isOccupied(m_tree.newNodes(), m_tree.tree().size(), marker); });
    parallelFor(m_claims.size(), kMarkersPerTask, [&](std::size_t begin, std::size_t end) {
        Neighbours neighbours;
        for (std::size_t i = begin; i < end; ++i) {
            // Buds come and go with the new nodes alone. If the owner is gone, those left of the others are
            // no nearer than it was.
            Claim& claim = m_claims[i];
            const Claim before = claim;
            const bool isGone = before.bud.node != kNoInternode &&
                                (m_tree.buds(before.bud.node) & budBit(before.bud.slot)) == 0;
            if (isGone)
                claim = {};
            contest(m_tree.newNodes(), m_tree.tree().size(), m_markers.positions[i], 0.0F, claim, neighbours);
            if (isGone)
                contest(m_space, 0, m_markers.positions[i], before.squaredDistance, claim, neighbours);
        }
    });
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

template <class IsOccupied>
void Competition::dropOccupied(std::size_t first, const IsOccupied& isOccupied)
{
    std::vector<std::uint8_t> gone(m_markers.size(), 0);
    parallelFor(m_markers.size() - first, kMarkersPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = first + begin; i < first + end; ++i)
            gone[i] = isOccupied(m_markers.positions[i]) ? 1 : 0;
    });
    m_markers.filter([&](std::size_t i) { return gone[i] == 0; });
    std::size_t i = 0;
    std::erase_if(m_claims, [&](const Claim&) { return gone[i++] != 0; });
}

bool Competition::isOccupied(const VoxelSpace& space, InternodeId offset, const Vec3& marker) const
{
    const float squaredRadius = m_perception.occupancy * m_perception.occupancy;
    return space.anyNear(marker, m_perception.occupancy, [&](VoxelSpace::Residents residents) {
        return std::ranges::any_of(residents, [&](const Resident& resident) {
            return resident.squaredDistance(marker) < squaredRadius && m_tree.buds(resident.id + offset) != 0;
        });
    });
}

void Competition::contest(const VoxelSpace& space, InternodeId offset, const Vec3& marker, float inner,
                          Claim& claim, Neighbours& neighbours) const
{
    const float near = m_perception.occupancy + kNearShare * (m_perception.reach - m_perception.occupancy);
    for (const float radius : {near, m_perception.reach}) {
        const float outer = std::min(radius * radius, claim.squaredDistance);
        if (outer < inner)
            continue;
        neighbours.clear();
        space.anyNear(marker, std::sqrt(outer), [&](VoxelSpace::Residents residents) {
            neighbours.add(residents, marker, inner, outer);
            return false;
        });
        for (float nearest = neighbours.nearest(); nearest <= claim.squaredDistance && nearest <= outer;
             nearest = neighbours.nearest())
            neighbours.take(nearest, [&](InternodeId id) { contend(id + offset, marker, claim); });
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
        Resident{position.x(), position.y(), position.z(), node}.squaredDistance(marker);
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

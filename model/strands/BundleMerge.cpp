// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/BundleMerge.h"

#include "model/strands/SlotAssignment.h"

#include <algorithm>

namespace espalier {

namespace {
/// Of the strands that are left, so many are compared, so that a fork of thousands costs no square of them.
constexpr std::size_t kMostLookedAt = 2000;
} // namespace

namespace {

float extentToward(std::span<const Vec2> places, const Vec2& direction)
{
    float extent = 0.0F;
    for (const Vec2& place : places)
        extent = std::max(extent, place.dot(direction));
    return extent;
}

} // namespace

float mergeDistance(std::span<const Vec2> placed, std::span<const Vec2> added, const Vec2& side)
{
    return extentToward(placed, side) + extentToward(added, Vec2(-side)) + 2.0F;
}

void BundleMerge::begin(std::span<const std::uint32_t> slots, std::uint32_t first)
{
    m_occupant.assign(slots.size(), HexLattice::kNone);
    for (std::uint32_t i = 0; i < slots.size(); ++i)
        m_occupant[slots[i]] = first + i;
}

void BundleMerge::add(std::span<const Vec2> places, std::uint32_t first, const Vec2& side)
{
    const auto count = static_cast<std::uint32_t>(places.size());
    const auto before = static_cast<std::uint32_t>(m_occupant.size());
    const std::uint32_t total = before + count;
    m_occupant.resize(total, HexLattice::kNone);
    const Vec2 target = m_lattice.radius(total) * side;
    chooseNearest(count, total, target);

    m_byDistance.clear();
    for (std::uint32_t slot = before; slot < total; ++slot) {
        if (m_isTaken[slot] == 0)
            m_byDistance.emplace_back((m_lattice.position(slot) - target).squaredNorm(), slot);
    }
    std::ranges::sort(m_byDistance);
    m_nextNearest = 0;
    for (const auto& [_, slot] : m_byDistance)
        fill(slot, total, target);

    m_slotPlaces.clear();
    for (const std::uint32_t slot : m_nearest) {
        m_slotPlaces.push_back(m_lattice.position(slot));
        m_isTaken[slot] = 0;
    }
    m_chosen.resize(count);
    assignSlots(places, m_slotPlaces, m_chosen);
    for (std::uint32_t i = 0; i < count; ++i)
        m_occupant[m_nearest[m_chosen[i]]] = first + i;
}

/// Makes the @p count slots that are nearest to @p target, of the first @p total, the taken ones.
void BundleMerge::chooseNearest(std::uint32_t count, std::uint32_t total, const Vec2& target)
{
    m_isTaken.resize(total, 0);
    m_byDistance.clear();
    // A half disc around the target that holds the strands, and some more.
    const float reach = 10.0F * static_cast<float>(count) + 50.0F;
    for (std::uint32_t slot = 0; slot < total; ++slot) {
        if (const float distance = (m_lattice.position(slot) - target).squaredNorm(); distance < reach)
            m_byDistance.emplace_back(distance, slot);
    }
    if (m_byDistance.size() < count) {
        m_byDistance.clear();
        for (std::uint32_t slot = 0; slot < total; ++slot)
            m_byDistance.emplace_back((m_lattice.position(slot) - target).squaredNorm(), slot);
    }
    std::ranges::nth_element(m_byDistance, m_byDistance.begin() + count - 1);
    m_nearest.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        m_nearest.push_back(m_byDistance[i].second);
        m_isTaken[m_byDistance[i].second] = 1;
    }
    std::ranges::sort(m_nearest);
}

/// Fills a free slot with the next strand toward the target, the slot of that one with the next, and so on,
/// until a taken slot becomes free.
void BundleMerge::fill(std::uint32_t hole, std::uint32_t total, const Vec2& target)
{
    std::uint32_t cursor = hole;
    for (;;) {
        float best = (m_lattice.position(cursor) - target).squaredNorm();
        std::uint32_t next = HexLattice::kNone;
        for (const std::uint32_t slot : m_lattice.neighbours(cursor)) {
            if (slot >= total)
                continue;
            if (const float distance = (m_lattice.position(slot) - target).squaredNorm(); distance < best) {
                best = distance;
                next = slot;
            }
        }
        if (next == HexLattice::kNone)
            break;
        cursor = next;
        if (m_occupant[cursor] == HexLattice::kNone)
            continue;
        m_occupant[hole] = std::exchange(m_occupant[cursor], HexLattice::kNone);
        if (m_isTaken[cursor] != 0)
            return;
        hole = cursor;
    }
    // No line leads to the strands that are left beside it: the nearest of them moves.
    while (m_occupant[m_nearest[m_nextNearest]] == HexLattice::kNone)
        ++m_nextNearest;
    std::uint32_t chosen = m_nearest[m_nextNearest];
    const std::size_t end = std::min(m_nearest.size(), m_nextNearest + kMostLookedAt);
    for (std::size_t i = m_nextNearest; i < end; ++i) {
        const std::uint32_t slot = m_nearest[i];
        if (m_occupant[slot] != HexLattice::kNone &&
            (m_lattice.position(slot) - m_lattice.position(hole)).squaredNorm() <
                (m_lattice.position(chosen) - m_lattice.position(hole)).squaredNorm())
            chosen = slot;
    }
    m_occupant[hole] = std::exchange(m_occupant[chosen], HexLattice::kNone);
}

void BundleMerge::finish(std::span<std::uint32_t> slots) const
{
    for (std::uint32_t slot = 0; slot < m_occupant.size(); ++slot)
        slots[m_occupant[slot]] = slot;
}

} // namespace espalier

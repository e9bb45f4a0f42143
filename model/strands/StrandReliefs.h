// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandSkeleton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace espalier {

/// What reliefs are made from: how strands lie in the cross-sections without them.
struct ReliefSources {
    const Tree& tree;
    const TreeIndex& index;
    const StrandSkeleton& skeleton;
    std::span<const float> scales; ///< Length of a strand radius, m, by node
    /// Place of one of the strands at a node, in strand radii.
    std::function<Vec2(std::uint32_t node, std::uint32_t strand)> place;
    /// Whether the section of a node has a profile, which is shown as it is drawn.
    std::function<bool(std::uint32_t node)> hasProfile;
};

/// How the outline of thick wood departs from that of its bundle, as wood does that thickens unevenly: along
/// the strands of a limb more new wood is laid down, so a ridge runs down from it and fades out; where the
/// strands of the largest limbs reach the ground, the root flare becomes a buttress; and where a thick limb
/// was lost, the wood has a hollow with a rim, which shrinks relative to the wood as that thickens.
///
/// A relief is a function of the angle in one cross-section. It moves strands straight outward or inward, the
/// outer ones most, so their order around the section and the topology of the outline stay the same.
class StrandReliefs {
public:
    /// Wood of fewer strands is not changed.
    static constexpr std::uint32_t kFewestStrands = 40;

    /// No reliefs.
    StrandReliefs() = default;
    /// WoodParameters::flutes scales the reliefs.
    explicit StrandReliefs(const ReliefSources& sources);

    /// A place in the section of a node, moved; in strand radii, like @p place. @p radius of the bundle
    /// there.
    Vec2 moved(std::uint32_t node, const Vec2& place, float radius) const
    {
        if (m_tableOf.empty() || m_tableOf[node] == kNone)
            return place;
        const float distance = place.norm();
        return (1.0F + relief(node, std::atan2(place.y(), place.x())) * std::min(distance / radius, 1.0F)) *
               place;
    }
    /// How far the outline is moved at an angle (rad, from the first axis of the section toward the second),
    /// as a share of the radius; −0.45...0.8, 0 where the outline is unchanged.
    float relief(std::uint32_t node, float angle) const
    {
        if (m_tableOf.empty() || m_tableOf[node] == kNone)
            return 0.0F;
        const Table& table = m_tables[m_tableOf[node]];
        const float turns = angle / (2.0F * std::numbers::pi_v<float>);
        const float place = (turns - std::floor(turns)) * static_cast<float>(kAngles);
        const auto below = static_cast<std::size_t>(place);
        const float share = place - static_cast<float>(below);
        return (1.0F - share) * table[below % kAngles] + share * table[(below + 1) % kAngles];
    }
    /// The relief of a node at angles that are evenly apart; empty for none.
    std::span<const float> around(std::uint32_t node) const
    {
        if (m_tableOf.empty() || m_tableOf[node] == kNone)
            return {};
        return m_tables[m_tableOf[node]];
    }
    std::size_t bytes() const
    {
        return m_tableOf.capacity() * sizeof(std::uint32_t) + m_tables.capacity() * sizeof(Table);
    }

private:
    static constexpr std::size_t kAngles = 128;
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    using Table = std::array<float, kAngles>;
    class Builder;

    Table& tableOf(std::uint32_t node);

    std::vector<std::uint32_t> m_tableOf; ///< By node; empty without any relief
    std::vector<Table> m_tables;
};

} // namespace espalier

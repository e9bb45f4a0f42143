// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/ContentHash.h"
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
    /// 1 where wood is round, and has all its reliefs; 0 where a profile is drawn, which is shown as it is
    /// meant; between them where a profile fades (NodeProfiles::roundness).
    std::function<float(std::uint32_t node)> roundness;
};

/// How the outline of thick wood departs from that of its bundle, as wood does that thickens unevenly: along
/// the strands of a limb more new wood is laid down, so a ridge runs down from it and fades out; where the
/// strands of the largest limbs reach the ground, the root flare becomes a buttress; and where a thick limb
/// was lost, the wood has a hollow with a rim, which shrinks relative to the wood as that thickens.
///
/// A relief is a function of the angle in one cross-section. It moves strands straight outward or inward, the
/// outer ones most, by less than half the radius inward; so their order around the section and along each
/// ray, and the topology of the outline, stay the same.
class StrandReliefs {
public:
    /// Wood of fewer strands is not changed.
    static constexpr std::uint32_t kFewestStrands = 40;

    /// No reliefs.
    StrandReliefs() = default;
    /// WoodParameters::flutes scales the reliefs.
    explicit StrandReliefs(const ReliefSources& sources);

    /// A place in the section of a node, moved by ridges and buttresses; in strand radii, like @p place.
    /// @p radius of the bundle there.
    Vec2 moved(std::uint32_t node, const Vec2& place, float radius) const
    {
        return place + m_ridges.shift(node, place, radius);
    }
    /// A cross-section on the way from the node below to a node.
    struct Between {
        float t = 1.0F;      ///< 0 at the node below, 1 at the node
        float length = 0.0F; ///< m, from one to the other
        float radius = 0.0F; ///< m, of the wood there
    };
    /// How far hollows move a place in a cross-section, m; @p place in metres from its middle, along the axes
    /// of the section of @p node, which is tilted but not twisted to get there. Hollows are about as short as
    /// wood is from node to node, so they belong to cross-sections and not to nodes.
    Vec2 sunk(std::uint32_t node, const Between& between, const Vec2& place) const
    {
        if (!hasHollow(node))
            return Vec2::Zero();
        return depth(node, between, std::atan2(place.y(), place.x())) *
               std::min(place.norm() / between.radius, 1.0F) * place;
    }
    bool hasHollow(std::uint32_t node) const
    {
        return !m_firstHollows.empty() && m_firstHollows[node] < m_firstHollows[node + 1];
    }

    /// How far ridges and buttresses move the outline of a node's section at an angle (rad, from its first
    /// axis toward its second), as a share of the radius: −0.45...0.8, 0 where it is unchanged.
    float ridge(std::uint32_t node, float angle) const { return m_ridges.height(node, angle); }
    /// How far hollows move it, likewise: −0.45...0.2.
    float hollow(std::uint32_t node, float radius, float angle) const
    {
        return hasHollow(node) ? depth(node, {.t = 1.0F, .length = 0.0F, .radius = radius}, angle) : 0.0F;
    }
    /// Adds all that the reliefs of a node are.
    void addTo(ContentHash& hash, std::uint32_t node) const;
    std::size_t bytes() const
    {
        return m_ridges.bytes() + m_firstHollows.capacity() * sizeof(std::uint32_t) +
               m_hollows.capacity() * sizeof(Hollow);
    }

private:
    static constexpr std::size_t kAngles = 128;
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    using Table = std::array<float, kAngles>;
    class Builder;

    /// Functions of the angle, of the nodes that have one.
    struct Layer {
        std::vector<std::uint32_t> tableOf; ///< By node; empty without any
        std::vector<Table> tables;

        bool has(std::uint32_t node) const { return !tableOf.empty() && tableOf[node] != kNone; }
        float height(std::uint32_t node, float angle) const
        {
            if (!has(node))
                return 0.0F;
            const Table& table = tables[tableOf[node]];
            const float turns = angle / (2.0F * std::numbers::pi_v<float>);
            const float place = (turns - std::floor(turns)) * static_cast<float>(kAngles);
            const auto below = static_cast<std::size_t>(place);
            const float share = place - static_cast<float>(below);
            return (1.0F - share) * table[below % kAngles] + share * table[(below + 1) % kAngles];
        }
        Vec2 shift(std::uint32_t node, const Vec2& place, float radius) const
        {
            if (!has(node))
                return Vec2::Zero();
            return height(node, std::atan2(place.y(), place.x())) * std::min(place.norm() / radius, 1.0F) *
                   place;
        }
        std::span<const float> around(std::uint32_t node) const
        {
            return has(node) ? std::span<const float>(tables[tableOf[node]]) : std::span<const float>();
        }
        /// The table of one of @p nodes nodes, of zeros if it had none.
        Table& of(std::uint32_t node, std::size_t nodes);
        std::size_t bytes() const
        {
            return tableOf.capacity() * sizeof(std::uint32_t) + tables.capacity() * sizeof(Table);
        }
    };

    /// A hollow near a node, as it is between the node below and this one.
    struct Hollow {
        float angle = 0.0F;  ///< In the section of the node
        float path = 0.0F;   ///< Of its middle above the node, m
        float radius = 0.0F; ///< From its middle to its rim, m
        float atBelow =
            1.0F; ///< Its share at the node below: 0 where that one has a profile, which is shown as drawn
        float atNode = 1.0F; ///< Likewise
    };

    float depth(std::uint32_t node, const Between& between, float angle) const;

    float m_strength = 0.0F;
    Layer m_ridges; ///< And buttresses
    std::vector<Hollow> m_hollows;
    std::vector<std::uint32_t> m_firstHollows; ///< By node, and their number; empty without any
};

} // namespace espalier

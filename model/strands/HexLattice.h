// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace espalier {

/// The places of discs of radius 1 in their densest arrangement, from the centre outward: the first N slots
/// are a round bundle of N strands, of which 50 and more fill 70 % of the circle around them. No two slots
/// are nearer than 2. Slots are ordered by their distance from the origin, which lies between points of the
/// lattice. A larger lattice begins with the slots of a smaller one.
class HexLattice {
public:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    /// Fill of an unbounded lattice: the share of the plane that discs cover, π / (2 √3).
    static constexpr double kFill = 0.9068996821171089;

    /// A lattice of at least @p slots slots.
    explicit HexLattice(std::uint32_t slots);

    std::uint32_t size() const { return static_cast<std::uint32_t>(m_positions.size()); }
    const Vec2& position(std::uint32_t slot) const { return m_positions[slot]; }
    /// The six slots around a slot, counter-clockwise from +X; kNone beyond the lattice.
    const std::array<std::uint32_t, 6>& neighbours(std::uint32_t slot) const { return m_neighbours[slot]; }
    /// Mean position of the first @p count slots, count > 0.
    Vec2 centroid(std::uint32_t count) const
    {
        return (m_sums[count] / static_cast<double>(count)).cast<float>();
    }
    /// The distance from the origin within which the first @p count slots lie, discs included.
    float radius(std::uint32_t count) const
    {
        return count == 0 ? 0.0F : m_positions[count - 1].norm() + 1.0F;
    }

private:
    std::vector<Vec2> m_positions;
    std::vector<std::array<std::uint32_t, 6>> m_neighbours;
    std::vector<Eigen::Vector2d> m_sums; ///< m_sums[n]: sum of the first n positions
};

} // namespace espalier

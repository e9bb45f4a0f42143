// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <vector>

namespace espalier {

/// How far places of the ground are from the branches placed so far, both projected down: the distance field
/// of Okabe 2005, 4.1 and figure 13. A field of kCells × kCells cells over a square; the values are exact
/// distances between a cell's centre and the stamped segments, as a segment only has to be compared with what
/// the field has already.
///
/// Points are (x, z), m.
class GroundDistances {
public:
    static constexpr int kCells = 128;
    /// The value while nothing is stamped, m. Finite, so that values can be interpolated.
    static constexpr float kFarAway = 1e30F;

    /// A field over the square around @p box, whose longer side is the square's.
    explicit GroundDistances(const Eigen::AlignedBox2d& box);

    /// Adds a segment, or a point if both ends are the same.
    void stamp(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

    /// The distance at the centre of a cell, m. @p column is along x, @p row along z; 0...kCells - 1.
    float value(int column, int row) const
    {
        return m_values[static_cast<std::size_t>(row * kCells + column)];
    }
    Eigen::Vector2d centre(int column, int row) const;
    /// The edge of a cell, m.
    double cellSize() const { return m_cell; }

    /// The distance at any place, interpolated between cells; beyond the square that of its border.
    double at(const Eigen::Vector2d& place) const;

    /// What the field says about a segment.
    struct Clearance {
        double mean = 0.0;  ///< m, over the segment
        double least = 0.0; ///< m, over the segment without its first fifth, which is always near the parent
    };
    /// @p from is the end at the parent. Sampled about once a cell.
    Clearance clearance(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

private:
    Eigen::Vector2d m_corner; ///< Of the square: least x and z
    double m_cell = 1.0;
    std::vector<float> m_values; ///< Row after row
};

} // namespace espalier

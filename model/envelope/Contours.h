// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Coverage.h"

#include <array>
#include <vector>

namespace espalier {

/// The line at which the values of a grid fall to a level, by marching squares: the inside on its left.
class Contours {
public:
    /// Values above @p level are inside; those at the grid's edge must be outside.
    Contours(const Grid<float>& values, float level);

    /// Closed lines, in units of nodes, which do not cross: regions counter-clockwise, holes clockwise.
    std::vector<Loop> loops() const;
    bool isEmpty() const { return m_segments.empty(); }

    /// Whether a corner of the square right of and above a node is inside and another is not.
    bool isCrossed(int x, int y) const
    {
        const std::size_t square = m_begin.index(x, y);
        return m_begin[square] < m_begin[square + 1];
    }
    /// The least squared distance from @p point to the line's parts in the squares within @p reach of the
    /// square (x, y); infinite if there is none.
    double squaredDistance(const Eigen::Vector2d& point, int x, int y, int reach) const;

private:
    struct Segment {
        Eigen::Vector2d from;
        Eigen::Vector2d to;
        int fromEdge; ///< Twice the node's index, plus 1 for the edge upward rather than rightward
        int toEdge;
    };

    std::vector<Segment> m_segments; ///< Square by square
    /// Index of a square's first segment; its segments end where those of the next square begin.
    Grid<int> m_begin;
};

/// How a line runs through a square of four nodes, numbered 0...3 counter-clockwise from the lower left:
/// pairs of the sides at which it enters and leaves, side k between corners k and k + 1; -1 for none.
std::array<std::array<int, 2>, 2> crossedSides(const std::array<bool, 4>& inside, bool centreInside);

} // namespace espalier

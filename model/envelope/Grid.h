// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace espalier {

/// Values on a lattice of width × height nodes, row after row.
template <class T>
class Grid {
public:
    Grid() = default;
    Grid(int width, int height, T value = T())
        : m_width(width),
          m_height(height),
          m_values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value)
    {
    }

    int width() const { return m_width; }
    int height() const { return m_height; }
    std::size_t size() const { return m_values.size(); }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < m_width && y < m_height; }

    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }
    T& operator()(int x, int y) { return m_values[index(x, y)]; }
    const T& operator()(int x, int y) const { return m_values[index(x, y)]; }
    T& operator[](std::size_t index) { return m_values[index]; }
    const T& operator[](std::size_t index) const { return m_values[index]; }

private:
    int m_width = 0;
    int m_height = 0;
    std::vector<T> m_values;
};

/// 1 inside, 0 outside.
using Mask = Grid<std::uint8_t>;

/// Where a point lies in the squares between the nodes of a grid.
struct GridPlace {
    int x = 0; ///< The square's lower left node
    int y = 0;
    double u = 0.0; ///< 0...1, from that node to the next
    double v = 0.0;
};

/// Bilinear interpolation; the place's square must lie in the grid.
template <class T>
double interpolate(const Grid<T>& grid, const GridPlace& place)
{
    const std::size_t below = grid.index(place.x, place.y);
    const std::size_t above = below + static_cast<std::size_t>(grid.width());
    const double lower = std::lerp(double{grid[below]}, double{grid[below + 1]}, place.u);
    const double upper = std::lerp(double{grid[above]}, double{grid[above + 1]}, place.u);
    return std::lerp(lower, upper, place.v);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace espalier {

/// Gradient noise in five octaves (Perlin 2002) on the unit square, repeating without a seam. It is computed
/// once into a table; textures read it at different scales and places.
class TileNoise {
public:
    static const TileNoise& shared();

    /// About −1...1, mean 0; the coarsest octave has four waves in the unit square. Any u, v ≥ −8; period 1
    /// in both: u and v multiplied by whole numbers give finer noise that still repeats.
    float operator()(float u, float v) const
    {
        const float x = (u + kShift) * kSize;
        const float y = (v + kShift) * kSize;
        const auto column = static_cast<std::uint32_t>(x);
        const auto row = static_cast<std::uint32_t>(y);
        const float fx = x - static_cast<float>(column);
        const float fy = y - static_cast<float>(row);
        const float* lower = m_values.data() + (row % kSize) * kStride + column % kSize;
        const float* upper = lower + kStride;
        const float below = lower[0] + fx * (lower[1] - lower[0]);
        const float above = upper[0] + fx * (upper[1] - upper[0]);
        return below + fy * (above - below);
    }

private:
    static constexpr std::uint32_t kSize = 512;
    /// One row and one column more, so that the last cells have neighbours.
    static constexpr std::uint32_t kStride = kSize + 1;
    static constexpr float kShift = 8.0F;

    TileNoise();

    std::vector<float> m_values;
};

/// Cells around one random point each, @p columns × @p rows of them on the unit square, repeating without a
/// seam.
class TileCells {
public:
    /// @p jitter 0...1: how far points lie from the cells' middles.
    TileCells(int columns, int rows, float jitter, std::uint32_t seed);

    /// The point of the cell that a place is in, and the place relative to it in units of a cell.
    struct Sample {
        float x = 0.0F;
        float y = 0.0F;
        float value = 0.0F; ///< 0...1, random, of the point
    };
    Sample own(float u, float v) const;

    /// The nearest point (Worley 1996), and how far the border to the second nearest is.
    struct Nearest : Sample {
        float edge = 0.0F;      ///< Distance to the border, ≥ 0
        float levelness = 0.0F; ///< 0 where the border stands upright, 1 where it lies level
    };
    Nearest nearest(float u, float v) const;

private:
    struct Point {
        float x;
        float y;
        float value;
    };

    int m_columns;
    int m_rows;
    std::vector<Point> m_points; ///< Offsets within their cells; with a margin of one cell all around
};

} // namespace espalier

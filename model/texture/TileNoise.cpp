// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/TileNoise.h"

#include "model/base/Random.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kOctaves = 5;
constexpr int kCoarsest = 4;
/// Scales the sum to about −1...1.
constexpr double kStrength = 1.1;

float fade(float t)
{
    return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

/// Adds gradient noise of @p waves × @p waves lattice cells to @p values, whose rows have @p stride elements,
/// of which @p size are used.
void addOctave(std::vector<float>& values, std::uint32_t size, std::uint32_t stride, std::uint32_t waves,
               float strength)
{
    Random random(0, waves, 0, Purpose::Texture);
    std::vector<Vec2> gradients(waves * waves);
    for (Vec2& gradient : gradients) {
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        gradient = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    }
    const std::uint32_t pixels = size / waves;
    for (std::uint32_t row = 0; row < size; ++row) {
        const std::uint32_t j = row / pixels;
        const float fy = static_cast<float>(row % pixels) / static_cast<float>(pixels);
        const float sy = fade(fy);
        const Vec2* lower = gradients.data() + j * waves;
        const Vec2* upper = gradients.data() + (j + 1) % waves * waves;
        for (std::uint32_t column = 0; column < size; ++column) {
            const std::uint32_t left = column / pixels;
            const std::uint32_t right = (left + 1) % waves;
            const float fx = static_cast<float>(column % pixels) / static_cast<float>(pixels);
            const float sx = fade(fx);
            const float a = lower[left].x() * fx + lower[left].y() * fy;
            const float b = lower[right].x() * (fx - 1.0F) + lower[right].y() * fy;
            const float c = upper[left].x() * fx + upper[left].y() * (fy - 1.0F);
            const float d = upper[right].x() * (fx - 1.0F) + upper[right].y() * (fy - 1.0F);
            const float below = a + sx * (b - a);
            values[row * stride + column] += strength * (below + sy * (c + sx * (d - c) - below));
        }
    }
}

} // namespace

const TileNoise& TileNoise::shared()
{
    static const TileNoise noise;
    return noise;
}

TileNoise::TileNoise() : m_values(std::size_t{kStride} * kStride, 0.0F)
{
    for (int octave = 0; octave < kOctaves; ++octave)
        addOctave(m_values, kSize, kStride, kCoarsest << octave,
                  static_cast<float>(std::ldexp(kStrength, -octave)));
    for (std::uint32_t row = 0; row < kSize; ++row)
        m_values[row * kStride + kSize] = m_values[row * kStride];
    std::copy_n(m_values.begin(), kStride, m_values.begin() + kSize * kStride);
}

TileCells::TileCells(int columns, int rows, float jitter, std::uint32_t seed)
    : m_columns(columns), m_rows(rows)
{
    std::vector<Point> points;
    Random random(seed, 1, 0, Purpose::Texture);
    for (int i = 0; i < columns * rows; ++i) {
        const double x = 0.5 + jitter * random.uniform(-0.5, 0.5);
        const double y = 0.5 + jitter * random.uniform(-0.5, 0.5);
        points.push_back(
            {static_cast<float>(x), static_cast<float>(y), static_cast<float>(random.uniform())});
    }
    for (int row = -1; row <= rows; ++row) {
        for (int column = -1; column <= columns; ++column) {
            const int source = (row + rows) % rows * columns + (column + columns) % columns;
            m_points.push_back(points[static_cast<std::size_t>(source)]);
        }
    }
}

TileCells::Sample TileCells::own(float u, float v) const
{
    const float x = (u - std::floor(u)) * static_cast<float>(m_columns);
    const float y = (v - std::floor(v)) * static_cast<float>(m_rows);
    const int column = std::min(static_cast<int>(x), m_columns - 1);
    const int row = std::min(static_cast<int>(y), m_rows - 1);
    const Point& point = m_points[static_cast<std::size_t>((row + 1) * (m_columns + 2) + column + 1)];
    return {x - static_cast<float>(column) - point.x, y - static_cast<float>(row) - point.y, point.value};
}

TileCells::Nearest TileCells::nearest(float u, float v) const
{
    const float x = (u - std::floor(u)) * static_cast<float>(m_columns);
    const float y = (v - std::floor(v)) * static_cast<float>(m_rows);
    const int column = std::min(static_cast<int>(x), m_columns - 1);
    const int row = std::min(static_cast<int>(y), m_rows - 1);
    const float fx = x - static_cast<float>(column);
    const float fy = y - static_cast<float>(row);

    struct Found {
        float x = 0.0F;
        float y = 0.0F;
        float squared = 1e9F;
        float value = 0.0F;
    };
    Found first;
    Found second;
    for (int j = -1; j <= 1; ++j) {
        const Point* point = m_points.data() + (row + 1 + j) * (m_columns + 2) + column;
        for (int i = -1; i <= 1; ++i, ++point) {
            const float dx = static_cast<float>(i) + point->x - fx;
            const float dy = static_cast<float>(j) + point->y - fy;
            const Found found{dx, dy, dx * dx + dy * dy, point->value};
            if (found.squared < first.squared) {
                second = first;
                first = found;
            } else if (found.squared < second.squared) {
                second = found;
            }
        }
    }
    // The border is the perpendicular bisector of the two.
    const float dx = second.x - first.x;
    const float dy = second.y - first.y;
    const float gap = std::sqrt(dx * dx + dy * dy) + 1e-6F;
    return {
        {-first.x, -first.y, first.value}, 0.5F * (second.squared - first.squared) / gap, std::abs(dy) / gap};
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/GroundDistances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace espalier {

GroundDistances::GroundDistances(const Eigen::AlignedBox2d& box)
    : m_values(static_cast<std::size_t>(kCells) * kCells, kFarAway)
{
    const double side = std::max(box.sizes().maxCoeff(), 1e-6);
    m_corner = box.center() - Eigen::Vector2d::Constant(0.5 * side);
    m_cell = side / kCells;
}

Eigen::Vector2d GroundDistances::centre(int column, int row) const
{
    return m_corner + m_cell * Eigen::Vector2d(column + 0.5, row + 0.5);
}

void GroundDistances::stamp(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    // In floats and relative to the first cell, so that the inner loop is vectorised.
    const Eigen::Vector2f begin = (from - centre(0, 0)).cast<float>();
    const Eigen::Vector2f step = (to - from).cast<float>();
    const float square = step.squaredNorm();
    const float inverse = square > 0.0F ? 1.0F / square : 0.0F;
    const auto cell = static_cast<float>(m_cell);
    for (int row = 0; row < kCells; ++row) {
        const float z = static_cast<float>(row) * cell - begin.y();
        float* values = m_values.data() + static_cast<std::ptrdiff_t>(row) * kCells;
        for (int column = 0; column < kCells; ++column) {
            const float x = static_cast<float>(column) * cell - begin.x();
            const float share = std::min(std::max((x * step.x() + z * step.y()) * inverse, 0.0F), 1.0F);
            const float dx = x - share * step.x();
            const float dz = z - share * step.y();
            const float distance = std::sqrt(dx * dx + dz * dz);
            values[column] = std::min(values[column], distance);
        }
    }
}

double GroundDistances::at(const Eigen::Vector2d& place) const
{
    const Eigen::Vector2d cells = (place - centre(0, 0)) / m_cell;
    const double x = std::clamp(cells.x(), 0.0, kCells - 1.0);
    const double z = std::clamp(cells.y(), 0.0, kCells - 1.0);
    const int column = std::min(static_cast<int>(x), kCells - 2);
    const int row = std::min(static_cast<int>(z), kCells - 2);
    const double u = x - column;
    const double near = std::lerp(double{value(column, row)}, double{value(column + 1, row)}, u);
    const double far = std::lerp(double{value(column, row + 1)}, double{value(column + 1, row + 1)}, u);
    return std::lerp(near, far, z - row);
}

GroundDistances::Clearance GroundDistances::clearance(const Eigen::Vector2d& from,
                                                      const Eigen::Vector2d& to) const
{
    const double cells = (to - from).norm() / m_cell;
    const int samples = std::clamp(static_cast<int>(std::ceil(cells)), 5, kCells);
    Clearance result{.mean = 0.0, .least = std::numeric_limits<double>::infinity()};
    for (int i = 1; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const double distance = at(from + share * (to - from));
        result.mean += distance / samples;
        if (share > 0.2)
            result.least = std::min(result.least, distance);
    }
    return result;
}

} // namespace espalier

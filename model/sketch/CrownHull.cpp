// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/CrownHull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace espalier {

namespace {

bool isLeftTurn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0.0;
}

/// Andrew's monotone chain, by ascending height: counter-clockwise from the lowest point.
SketchLine convexCorners(std::span<const Eigen::Vector2d> points)
{
    SketchLine sorted(points.begin(), points.end());
    std::ranges::sort(sorted, [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.y() < b.y() || (a.y() == b.y() && a.x() > b.x());
    });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3)
        return sorted;
    SketchLine corners;
    const auto extend = [&](const Eigen::Vector2d& point, std::size_t least) {
        while (corners.size() > least && !isLeftTurn(corners[corners.size() - 2], corners.back(), point))
            corners.pop_back();
        corners.push_back(point);
    };
    for (const Eigen::Vector2d& point : sorted)
        extend(point, 1);
    const std::size_t right = corners.size();
    for (std::size_t i = sorted.size() - 1; i-- > 0;)
        extend(sorted[i], right);
    corners.pop_back();
    return corners;
}

} // namespace

CrownHull::CrownHull(std::span<const Eigen::Vector2d> points, double magnification)
    : m_corners(convexCorners(points)), m_magnification(magnification)
{
    m_top = m_corners.front().y();
    for (const Eigen::Vector2d& corner : m_corners)
        m_top = std::max(m_top, corner.y());
}

CrownHull::Circle CrownHull::circle(double y) const
{
    const double height = std::clamp(y, bottom(), top());
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        const Eigen::Vector2d& a = m_corners[i];
        const Eigen::Vector2d& b = m_corners[(i + 1) % m_corners.size()];
        const auto [low, high] = std::minmax(a.y(), b.y());
        if (height < low || height > high)
            continue;
        const bool isLevel = high == low;
        const double x = isLevel ? a.x() : std::lerp(a.x(), b.x(), (height - a.y()) / (b.y() - a.y()));
        left = std::min({left, x, isLevel ? b.x() : x});
        right = std::max({right, x, isLevel ? b.x() : x});
    }
    return {.middle = 0.5 * (left + right), .radius = 0.5 * m_magnification * (right - left)};
}

bool CrownHull::contains(const Eigen::Vector3d& point) const
{
    const double slack = 1e-9 * (1.0 + top() - bottom() + std::abs(point.x()));
    if (point.y() < bottom() - slack || point.y() > top() + slack)
        return false;
    const Circle around = circle(point.y());
    return std::hypot(point.x() - around.middle, point.z()) <= around.radius + slack;
}

Eigen::AlignedBox2d CrownHull::footprint() const
{
    // Both sides of the circles are straight between the heights of two corners, so the corners suffice.
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : m_corners) {
        const Circle around = circle(corner.y());
        box.extend(Eigen::Vector2d(around.middle - around.radius, -around.radius));
        box.extend(Eigen::Vector2d(around.middle + around.radius, around.radius));
    }
    return box;
}

} // namespace espalier

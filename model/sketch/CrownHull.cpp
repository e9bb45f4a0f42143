// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/CrownHull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ranges>

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
    const auto summit =
        std::ranges::is_sorted_until(m_corners, {}, [](const Eigen::Vector2d& corner) { return corner.y(); });
    m_summit = static_cast<std::size_t>(summit - m_corners.begin()) - 1;
    m_top = m_corners[m_summit].y();
}

CrownHull::Circle CrownHull::circle(double y) const
{
    const double height = std::clamp(y, bottom(), top());
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    const auto corner = [&](std::size_t i) -> const Eigen::Vector2d& {
        return m_corners[i % m_corners.size()];
    };
    const auto extend = [&](std::size_t edge) {
        const Eigen::Vector2d& a = corner(edge);
        const Eigen::Vector2d& b = corner(edge + 1);
        const bool isLevel = a.y() == b.y();
        const double x = isLevel ? a.x() : std::lerp(a.x(), b.x(), (height - a.y()) / (b.y() - a.y()));
        left = std::min({left, x, isLevel ? b.x() : x});
        right = std::max({right, x, isLevel ? b.x() : x});
    };
    // The edges that reach the height: on the way up, and on the way down.
    const auto firstWhere = [](std::size_t first, std::size_t last, auto&& isBefore) {
        const auto edges = std::views::iota(first, last);
        return first +
               static_cast<std::size_t>(std::ranges::partition_point(edges, isBefore) - edges.begin());
    };
    const std::size_t up = firstWhere(0, m_summit, [&](std::size_t i) { return corner(i + 1).y() < height; });
    for (std::size_t i = up; i < m_summit && corner(i).y() <= height; ++i)
        extend(i);
    const std::size_t down =
        firstWhere(m_summit, m_corners.size(), [&](std::size_t i) { return corner(i + 1).y() > height; });
    for (std::size_t i = down; i < m_corners.size() && corner(i).y() >= height; ++i)
        extend(i);
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

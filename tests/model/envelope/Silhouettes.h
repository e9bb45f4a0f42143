// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/LassoLoop.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace espalier::test {

using Points = std::vector<Vec2>;

/// Points of a closed curve, the first not repeated; @p at takes 0...1.
inline Points curve(int count, const std::function<std::pair<double, double>(double)>& at)
{
    Points points;
    for (int i = 0; i < count; ++i) {
        const auto [x, y] = at(static_cast<double>(i) / count);
        points.emplace_back(static_cast<float>(x), static_cast<float>(y));
    }
    return points;
}

inline Points circle(double radius, double x = 0.0, double y = 0.0, int count = 200)
{
    return curve(count, [&](double t) {
        const double angle = 2.0 * std::numbers::pi * t;
        return std::pair(x + radius * std::cos(angle), y + radius * std::sin(angle));
    });
}

inline Points heart()
{
    return curve(150, [](double t) {
        const double a = 2.0 * std::numbers::pi * t;
        return std::pair(16.0 * std::pow(std::sin(a), 3), 13.0 * std::cos(a) - 5.0 * std::cos(2.0 * a) -
                                                              2.0 * std::cos(3.0 * a) - std::cos(4.0 * a));
    });
}

inline Points arch()
{
    Points points{{-2.0F, 0.0F}, {-2.0F, 2.0F}};
    for (int i = 1; i < 40; ++i) {
        const double angle = std::numbers::pi * (1.0 - i / 40.0);
        points.emplace_back(static_cast<float>(2.0 * std::cos(angle)),
                            static_cast<float>(2.0 + 2.0 * std::sin(angle)));
    }
    points.insert(points.end(), {{2.0F, 2.0F}, {2.0F, 0.0F}, {1.2F, 0.0F}, {1.2F, 2.0F}});
    for (int i = 1; i < 40; ++i) {
        const double angle = std::numbers::pi * i / 40.0;
        points.emplace_back(static_cast<float>(1.2 * std::cos(angle)),
                            static_cast<float>(2.0 + 1.2 * std::sin(angle)));
    }
    points.insert(points.end(), {{-1.2F, 2.0F}, {-1.2F, 0.0F}});
    return points;
}

/// Body, neck and head as one line that is thick, thin and thicker again; its sides cross in the bends.
inline Points swan()
{
    const auto middle = [](double t) {
        return Vec2(static_cast<float>(-2.5 + 4.0 * t - 1.2 * std::sin(6.0 * t) * t),
                    static_cast<float>(3.6 * t * t - 0.5 * std::cos(5.0 * t)));
    };
    const auto halfWidth = [](double t) {
        return 0.08 + 0.75 * std::exp(-30.0 * std::pow(t - 0.25, 2)) +
               0.2 * std::exp(-400.0 * std::pow(t - 0.93, 2));
    };
    Points left;
    Points right;
    for (int i = 0; i <= 80; ++i) {
        const double t = i / 80.0;
        const Vec2 along = (middle(t + 1e-3) - middle(t - 1e-3)).normalized();
        const Vec2 across(-along.y(), along.x());
        left.push_back(middle(t) + static_cast<float>(halfWidth(t)) * across);
        right.push_back(middle(t) - static_cast<float>(halfWidth(t)) * across);
    }
    right.insert(right.end(), left.rbegin(), left.rend());
    return right;
}

inline Points letterE()
{
    return {{0, 0},       {3, 0},    {3, 0.8F}, {1, 0.8F}, {1, 2}, {2.5F, 2},
            {2.5F, 2.8F}, {1, 2.8F}, {1, 4.2F}, {3, 4.2F}, {3, 5}, {0, 5}};
}

/// The outer line of an A; its hole is letterAHole().
inline Points letterA()
{
    return {{0, 0}, {1, 0}, {1.5F, 1.5F}, {2.9F, 1.5F}, {3.4F, 0}, {4.4F, 0}, {2.8F, 5}, {1.6F, 5}};
}

inline Points letterAHole()
{
    return {{1.75F, 2.3F}, {2.65F, 2.3F}, {2.2F, 3.8F}};
}

inline Points letterS()
{
    Points left;
    Points right;
    for (int i = 0; i <= 60; ++i) {
        const double t = std::numbers::pi * (i / 60.0 - 0.5) * 2.6;
        const Vec2 middle(static_cast<float>(-1.3 * std::sin(t * 0.9)), static_cast<float>(0.75 * t));
        const Vec2 along = Vec2(static_cast<float>(-1.17 * std::cos(t * 0.9)), 0.75F).normalized();
        const Vec2 across(-along.y(), along.x());
        left.push_back(middle + 0.35F * across);
        right.push_back(middle - 0.35F * across);
    }
    right.insert(right.end(), left.rbegin(), left.rend());
    return right;
}

/// Whether a closed polygon winds around a point.
inline bool encloses(const Points& polygon, double x, double y)
{
    int winding = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d a = polygon[i].cast<double>();
        const Eigen::Vector2d b = polygon[(i + 1) % polygon.size()].cast<double>();
        const double side = (b.x() - a.x()) * (y - a.y()) - (x - a.x()) * (b.y() - a.y());
        if (a.y() <= y && b.y() > y && side > 0.0)
            ++winding;
        if (a.y() > y && b.y() <= y && side < 0.0)
            --winding;
    }
    return winding != 0;
}

/// Area of the intersection divided by that of the union of two regions, at about @p steps² points in and
/// around a polygon's box.
inline double overlap(const Points& polygon, int steps, const std::function<bool(double, double)>& first,
                      const std::function<bool(double, double)>& second)
{
    Eigen::AlignedBox2d box;
    for (const Vec2& point : polygon)
        box.extend(point.cast<double>());
    const Eigen::Vector2d corner = box.min() - 0.05 * box.sizes();
    const Eigen::Vector2d size = 1.1 * box.sizes();
    int both = 0;
    int either = 0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double x = corner.x() + size.x() * (i + 0.37) / steps;
            const double y = corner.y() + size.y() * (j + 0.61) / steps;
            const bool a = first(x, y);
            const bool b = second(x, y);
            both += a && b ? 1 : 0;
            either += a || b ? 1 : 0;
        }
    }
    return static_cast<double>(both) / either;
}

} // namespace espalier::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/SketchLine.h"

#include <cstddef>
#include <numbers>
#include <span>

namespace espalier {

/// The space that the branches of a drawing may take: a circle, swept from the bottom to the top of the
/// drawing's convex hull and enlarged (Okabe 2005, 4.1 and figure 14).
class CrownHull {
public:
    /// The hull of points of the drawing, one or more, m. @p magnification: of the circle's radius, > 0.
    explicit CrownHull(std::span<const Eigen::Vector2d> points, double magnification = std::numbers::sqrt2);

    /// A horizontal circle around (middle, y, 0).
    struct Circle {
        double middle = 0.0; ///< x, m: the middle between the two sides of the convex hull
        double radius = 0.0; ///< m: half their distance, enlarged
    };

    /// The circle at a height, which is clamped to the drawing's.
    Circle circle(double y) const;
    /// Whether a point of space is in the hull or on it, but for a billionth of the hull's size.
    bool contains(const Eigen::Vector3d& point) const;

    double bottom() const { return m_corners.front().y(); }
    double top() const { return m_top; }
    /// The horizontal box around all circles: its corners are (least x, -r) and (greatest x, r), for x and z.
    Eigen::AlignedBox2d footprint() const;
    /// The corners of the convex hull in the drawing, counter-clockwise from the lowest one.
    const SketchLine& corners() const { return m_corners; }

private:
    SketchLine m_corners;
    std::size_t m_summit; ///< Corner up to which heights ascend, and after which they descend
    double m_top = 0.0;
    double m_magnification = 1.0;
};

} // namespace espalier

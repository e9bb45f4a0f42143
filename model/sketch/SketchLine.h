// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// A polyline in the plane of the drawing, z = 0: x to the right, y up, in metres, or in pixels where a
/// function says so.
using SketchLine = std::vector<Eigen::Vector2d>;

/// The arc length of a line; 0 for one point or none.
double lengthOf(const SketchLine& line);

/// For each point of a line the share of the arc length up to it: 0...1, ascending; all 0 if the line has no
/// length.
std::vector<double> arcShares(const SketchLine& line);

/// The point of a line at the share @p along (0...1, clamped) of its arc length. The line has a point or
/// more.
Eigen::Vector2d pointAlong(const SketchLine& line, double along);

/// @p count points (2 or more) at even distances along a line of a point or more; the ends stay.
SketchLine evenLine(const SketchLine& line, std::size_t count);

/// Where a line is nearest to a point.
struct PlaceOnLine {
    double along = 0.0; ///< 0...1, share of the line's arc length
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    double distance = 0.0; ///< From the given point
};

/// The place on a line of a point or more that is nearest to @p point; the first one of several.
PlaceOnLine nearestPlace(const SketchLine& line, const Eigen::Vector2d& point);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// A stroke of the lasso as a document keeps it: points in the plane in which it was drawn.
struct LassoStroke {
    Vec3 origin = Vec3::Zero(); ///< m
    Vec3 right = Vec3::UnitX(); ///< Unit; the first axis of the plane
    Vec3 up = Vec3::UnitY();    ///< Unit, orthogonal to right
    std::vector<Vec2> points;   ///< m along right and up from the origin; the ends need not meet

    bool operator==(const LassoStroke&) const = default;
};

/// No more points than this are left of a stroke.
inline constexpr std::size_t kMostLassoPoints = 2000;
/// Points farther than this from the plane's origin are taken for mistakes of a device, m.
inline constexpr float kFarthestLassoPoint = 1e7F;

/// The points of a raw stroke with which it keeps its form: those that are not finite (or absurdly far) and
/// those that repeat their predecessor go, and so do those that lie within @p tolerance (a share of the
/// stroke's longer side) of the line that is left. Should more than kMostLassoPoints be left, the tolerance
/// is doubled until they are few enough, up to a hundredth of the side. No removed point is farther than 1.5
/// tolerances from the new line, whose ends are the stroke's. Of a scribble that is too long even so, evenly
/// spaced points are left. Linear in the number of points.
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance = 1.0 / 2048.0);

/// The loop that a simplified stroke means, its last point joined to its first. Hands close a loop by
/// crossing its beginning: where an end crosses the other, both tails are cut off at the crossing, if they
/// are together at most @p longestTails of the stroke's length.
std::vector<Vec2> closedLoop(const std::vector<Vec2>& points, double longestTails = 0.15);

/// Whether both strokes were drawn in the same plane, up to rounding; their origins and axes in it may
/// differ.
bool coplanar(const LassoStroke& first, const LassoStroke& second);

} // namespace espalier

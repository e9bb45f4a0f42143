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

/// The greatest number of points of a stroke; simplification removes the rest (model/envelope/LassoLoop.h).
inline constexpr std::size_t kMostLassoPoints = 2000;
/// The greatest coordinate of a point, m, along right and up. Greater ones are errors of an input device.
inline constexpr float kFarthestLassoPoint = 1e7F;
/// The greatest coordinate of the plane's origin, m, along each axis of the world.
inline constexpr float kFarthestLassoPlane = 1e6F;

/// Whether a document may contain @p stroke: right and up are orthogonal unit vectors, and the coordinates
/// and the number of points are within the limits above.
bool isLasso(const LassoStroke& stroke);

} // namespace espalier

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
/// The plane's origin is within this of the world's, each way, m.
inline constexpr float kFarthestLassoPlane = 1e6F;

/// Whether a document may keep such a stroke: a plane that is one, and points that are few enough and near
/// enough.
bool isLasso(const LassoStroke& stroke);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

namespace espalier {

/// The tropism vector T: up, turned by the gravitropic set-point angle @p theta (rad) in the vertical plane
/// of the unit vector @p heading. If that is vertical, the plane is that of the horizontal unit vector
/// @p levelDirection (TreeSketch §3.2).
Vec3 tropismVector(const Vec3& heading, double theta, const Vec3& levelDirection);

/// Weights of eq. 2; each ≥ 0.
struct DirectionWeights {
    double axis = 0.5;    ///< α
    double tropism = 0.2; ///< β
    double space = 0.3;   ///< γ
};

/// The new growth direction H' = normalize(αH + βT + γE), a unit vector. Without free space (E = 0) the other
/// two weights share γ's part. If the sum vanishes, the heading is kept.
Vec3 growthDirection(const DirectionWeights& weights, const Vec3& heading, const Vec3& tropism,
                     const Vec3& space);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <vector>

namespace espalier {

/// The figure that a tree gets, as the user drew it: m, right and up in an upright plane, not smoothed.
struct TreeFigure {
    static constexpr double kMostAzimuth = 180.0; ///< °

    std::vector<Vec2> trunk;      ///< An open stroke
    std::vector<Vec2> silhouette; ///< Of the crown; its convex hull counts
    /// Where the drawing is seen from: ° from +Z toward +X, −kMostAzimuth...kMostAzimuth.
    double azimuth = 0.0;

    bool operator==(const TreeFigure&) const = default;
};

} // namespace espalier

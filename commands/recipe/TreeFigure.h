// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <vector>

namespace espalier {

/// The figure that a tree gets, as the user drew it: m, right and up, not smoothed.
struct TreeFigure {
    std::vector<Vec2> trunk;      ///< An open stroke
    std::vector<Vec2> silhouette; ///< Of the crown; its convex hull counts

    bool operator==(const TreeFigure&) const = default;
};

} // namespace espalier

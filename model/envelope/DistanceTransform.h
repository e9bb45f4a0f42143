// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Grid.h"

#include <limits>

namespace espalier {

/// The cost of a node that is not a site.
inline constexpr double kNoSite = std::numeric_limits<double>::infinity();

struct DistanceTransform {
    Grid<double> value; ///< min over sites q of |p - q|² + cost(q), in squares of the nodes' spacing
    Grid<int> site; ///< Index in the grid of the site at which that minimum is reached, -1 without any site
};

/// Exact, linear in the number of nodes: the lower envelope of the sites' parabolas along columns, then along
/// rows (Felzenszwalb & Huttenlocher 2012). With costs of 0 these are squared Euclidean distances; with costs
/// of -R² the negated value is what the balls of radius R around the sites rise to, squared.
DistanceTransform distanceTransform(const Grid<double>& cost);

} // namespace espalier

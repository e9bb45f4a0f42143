// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"
#include "model/tree/TreeTables.h"

#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Extremities of a region that have the same diameter.
struct WidthExtremities {
    double count = 1.0;
    double logDiameter = 0.0; ///< ln m
};

/// The formula for the diameters in a region of a tree.
struct WidthLaw {
    double exponent; ///< n of d^n = Σ d_i^n, 0.5...10
    /// If no exponent in that range leads to the base's diameter: ln of a factor that does. It is applied
    /// fully at the base, not at all at the extremities, and in part between.
    double logFactor;
};

/// Solves d^n = Σ d_i^n for n (TreeSketch §3.3, eq. 3), with the base's diameter d and the extremities'
/// diameters d_i, by Newton's method on the logarithm of the sum, which is convex and falls: from the lower
/// end of a bracket the method cannot overshoot. With a single extremity, or a base without a diameter (no @p
/// logBase), n is @p fallback; in the latter case there is no factor.
WidthLaw solveWidths(std::optional<double> logBase, std::span<const WidthExtremities> extremities,
                     double fallback);

/// ln d for d^n = Σ d_i^n.
double logDiameter(double exponent, std::span<const WidthExtremities> extremities);

/// Radii of all internodes, m, 0 for dead ones, for @p constraints of living internodes in ascending order.
/// The cost is a pass over the rows, and the paths that lead down from the constraints. @p power: p of
/// d = d_e · tips^p, which gives the base diameters of trunks that carry fewer tips than the greatest one.
std::vector<float> constrainedRadii(const Tree& tree, const TreeIndex& index,
                                    std::span<const WidthConstraint> constraints, double power);

} // namespace espalier

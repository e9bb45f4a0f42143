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

/// What makes the diameters in a region of a tree.
struct WidthLaw {
    double exponent; ///< n of d^n = Σ d_i^n, 0.5...10
    /// Where no such exponent leads to the base's diameter: ln of the factor that does, to be applied fully
    /// at the base, not at all at the extremities, and in part between.
    double logFactor;
};

/// Solves d^n = Σ d_i^n for n (TreeSketch §3.3, eq. 3), d being the base's diameter and d_i those of the
/// extremities, by Newton's method on the logarithm of the sum, which is convex and falls: from the lower
/// end of a bracket it cannot overshoot. A single extremity leaves @p fallback for n; so does a base without
/// a diameter (no @p logBase), and then there is no factor.
WidthLaw solveWidths(std::optional<double> logBase, std::span<const WidthExtremities> extremities,
                     double fallback);

/// ln d for d^n = Σ d_i^n.
double logDiameter(double exponent, std::span<const WidthExtremities> extremities);

/// Radii of all internodes, m, 0 for the dead, for @p constraints, which are of living internodes and
/// ascending. The cost is a pass over the rows, and the paths that lead down from the constraints.
std::vector<float> constrainedRadii(const Tree& tree, const TreeIndex& index,
                                    std::span<const WidthConstraint> constraints);

} // namespace espalier

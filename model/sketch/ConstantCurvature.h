// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/SketchLine.h"

#include <optional>
#include <vector>

namespace espalier {

struct ConstantCurvatureOptions {
    double elevationLimit =
        radians(50.0);     ///< The greatest |φ|, rad, 0...π/2 (excluded): there the curve turns back
    double quantile = 1.0; ///< K is this quantile (0...1) of the stroke's |curvature|; 1: its greatest
    double side = 1.0;     ///< The curve leaves the plane toward +z (1) or -z (-1) first
    std::optional<double> endDepth =
        std::nullopt; ///< m, relative to the base; none: where the curve ends by itself
};

/// Depths that give a planar stroke the same curvature K everywhere in space: for each point its z relative
/// to the first point, in metres; x and y stay the stroke's, so the curve's projection is the stroke itself.
/// Straight parts bend in depth, parts that are bent most stay parallel to the drawing.
///
/// With k the stroke's curvature, s its arc length and φ the elevation of the tangent out of the drawing:
/// φ' = ±√((K / cos φ)² - (k cos φ)²), z' = tan φ, φ(0) = 0. The sign changes where |φ| reaches the limit.
/// An end depth adds a term that is linear in s. A straight stroke, and an arc of a circle, stay planar; so
/// does a line of one point or none.
///
/// Source: Okabe 2005, 4.1, which names the algorithm of Ijiri et al. 2005; this is a derivation from its
/// assumption of constant curvature and may differ from theirs.
std::vector<double> constantCurvatureDepths(const SketchLine& line,
                                            const ConstantCurvatureOptions& options = {});

} // namespace espalier

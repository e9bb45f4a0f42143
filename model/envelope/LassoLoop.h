// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/LassoStroke.h"

namespace espalier {

/// Returns the points of a raw stroke that its form needs. Removes points that are not finite (or too far
/// away), points that repeat their predecessor, and points that lie within @p tolerance (a share of the
/// stroke's longer side) of the remaining line. If more than kMostLassoPoints remain, the tolerance is
/// doubled until they are few enough, up to a hundredth of the side. No removed point is farther than 1.5
/// tolerances from the new line, whose ends are the stroke's. A scribble that is too long even then is
/// reduced to evenly spaced points. Linear in the number of points.
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance = 1.0 / 2048.0);

/// The outline as seen when the tree has turned by 90° around the vertical through @p stroke's origin: a
/// crown that fills both is as deep as it is wide, like a drawing that is placed twice (Okabe 2005, 4.1).
LassoStroke turnedToTheSide(LassoStroke stroke);

/// The closed loop of a simplified stroke, its last point joined to its first. People close a loop by
/// crossing its beginning: where the two ends cross, both tails are cut off at the crossing, if they are
/// together at most @p longestTails of the stroke's length.
std::vector<Vec2> closedLoop(const std::vector<Vec2>& points, double longestTails = 0.15);

/// Whether both strokes were drawn in the same plane, up to rounding; their origins and axes in it may
/// differ.
bool coplanar(const LassoStroke& first, const LassoStroke& second);

} // namespace espalier

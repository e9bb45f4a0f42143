// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/LassoStroke.h"

namespace espalier {

/// The points of a raw stroke with which it keeps its form: those that are not finite (or absurdly far) and
/// those that repeat their predecessor go, and so do those that lie within @p tolerance (a share of the
/// stroke's longer side) of the line that is left. Should more than kMostLassoPoints be left, the tolerance
/// is doubled until they are few enough, up to a hundredth of the side. No removed point is farther than 1.5
/// tolerances from the new line, whose ends are the stroke's. Of a scribble that is too long even so, evenly
/// spaced points are left. Linear in the number of points.
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance = 1.0 / 2048.0);

/// The loop that a simplified stroke means, its last point joined to its first. Hands close a loop by
/// crossing its beginning: where an end crosses the other, both tails are cut off at the crossing, if they
/// are together at most @p longestTails of the stroke's length.
std::vector<Vec2> closedLoop(const std::vector<Vec2>& points, double longestTails = 0.15);

/// Whether both strokes were drawn in the same plane, up to rounding; their origins and axes in it may
/// differ.
bool coplanar(const LassoStroke& first, const LassoStroke& second);

} // namespace espalier

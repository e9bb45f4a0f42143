// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/StrandProfile.h"

#include <span>

namespace espalier {

/// A profile between @p from (@p share = 0) and @p to (@p share = 1). If both have as many parts and
/// cavities, their outlines are matched by their places, resampled by arc length and blended point by point.
/// Otherwise, or where that would cross, the result is the outline of the blended distances from both
/// boundaries: so a part divides, and a cavity closes, at some place between. Attractors are blended in their
/// order; those that only one has are in the nearer half. The result has no fault. A pure function.
/// Precondition: neither has one.
StrandProfile blendedProfile(const StrandProfile& from, const StrandProfile& to, float share);

/// The outline that a hand-drawn line means: its ends are joined, it is smoothed, and points that its form
/// does not need are left out. A loop of 3 to some 60 points, which may cross itself; empty for a line that
/// is shorter than @p least from side to side.
StrandProfile::Loop sketchedLoop(std::span<const Vec2> stroke, float least);

} // namespace espalier

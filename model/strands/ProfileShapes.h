// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/StrandProfile.h"

namespace espalier {

/// Ready-made profiles.
enum class ProfileShape : int { Round, Elongated, CShape, Ring, TwoParts, ThreeParts, Fluted };
inline constexpr int kProfileShapeCount = 7;

/// A ready-made profile, centred at the origin; its area is about that of the unit circle. It has no
/// attractors.
StrandProfile profileOf(ProfileShape shape);

} // namespace espalier

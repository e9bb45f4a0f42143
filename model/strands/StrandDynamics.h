// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/StrandProfile.h"

#include <cstdint>
#include <span>

namespace espalier {

/// Packs discs of radius 1 by position based dynamics with the constants of Strands 2024 §6: a pull toward
/// the middle, or with a profile toward its boundary from outside and its attractors from inside, Verlet
/// steps of 0.002 with damping 0.02 and speed at most 60, and collisions with softness 0.1. At these
/// constants the discs do not come to rest; @p steps decides how the result looks (figure 14). At most five
/// steps a disc are made. @p profile may be null; its coordinates times @p scale are those of the places.
void packByDynamics(std::span<Vec2> places, int steps, const StrandProfile* profile, float scale);

} // namespace espalier

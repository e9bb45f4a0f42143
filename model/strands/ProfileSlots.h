// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/StrandProfile.h"

#include <cstdint>
#include <vector>

namespace espalier {

/// Places for strands in a profile (Strands 2024 §5.3).
struct ProfileSlots {
    float scale = 0.0F;       ///< From the profile's coordinates to those of the places, in strand radii
    std::vector<Vec2> places; ///< No two nearer than 2, all inside the scaled profile
};

/// The places of @p strands strands (at least one): a hexagonal lattice in the profile, which is as large as
/// that takes. With attractors the profile is a quarter larger, and the places are those nearest to them.
/// Precondition: profileFault(profile) is empty.
ProfileSlots profileSlots(const StrandProfile& profile, std::uint32_t strands);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/StrandProfile.h"

#include <vector>

namespace espalier {

struct MedialSegment {
    Vec2 from = Vec2::Zero();
    Vec2 to = Vec2::Zero();
};

/// The medial axis of a profile: the places inside it that are equally far from two sides of its boundary
/// (Strands 2024 §5.3), in the profile's coordinates. The Voronoi diagram of some 400 points of the boundary
/// approximates it; branches that end at blunt corners, of more than about 110°, are left out. A circle's
/// axis is a dot: segments much shorter than its radius. Parts that are thinner than the distance of those
/// points may have none. A pure function. Precondition: profileFault(profile) is empty.
std::vector<MedialSegment> medialAxis(const StrandProfile& profile);

} // namespace espalier

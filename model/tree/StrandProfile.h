// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace espalier {

/// The shape of a cross-section that the user has sketched (Strands 2024 §5.3). Coordinates are in the plane
/// of the node's strands; their unit is the radius of the round section that the node would have without a
/// profile. Only the shape counts: the section is as large as its strands want it.
struct StrandProfile {
    using Loop = std::vector<Vec2>;
    /// A line that strands gather at.
    struct Attractor {
        Vec2 from = Vec2::Zero();
        Vec2 to = Vec2::Zero();
        bool operator==(const Attractor&) const = default;
    };

    /// Closed polygons; the last point joins the first. A point is inside if an odd number of polygons
    /// contain it: so a polygon in another one is a cavity, and polygons beside each other are parts of a
    /// split trunk.
    std::vector<Loop> boundaries;
    std::vector<Attractor> attractors;

    bool operator==(const StrandProfile&) const = default;
    std::size_t bytes() const;
};

/// Limits of a profile.
inline constexpr std::size_t kMostProfileLoops = 32;
inline constexpr std::size_t kMostProfilePoints = 2000; ///< Of all boundaries together
inline constexpr std::size_t kMostAttractors = 64;
inline constexpr float kFarthestProfilePoint = 100.0F; ///< The greatest coordinate
/// The least area of a profile, the area of its cavities taken away.
inline constexpr float kLeastProfileArea = 1e-4F;

/// Whether the profile contains a point, by the even-odd rule.
bool isInside(const StrandProfile& profile, const Vec2& point);
/// The area that the profile contains.
float areaOf(const StrandProfile& profile);
/// The signed area of a polygon, positive if it runs counter-clockwise.
float signedAreaOf(const StrandProfile::Loop& loop);

/// Describes the first fault of a profile in a sentence without a full stop ("its outline crosses itself");
/// empty if there is none. Boundaries must be simple polygons of at least three points, which do not cross
/// each other, around some area.
QString profileFault(const StrandProfile& profile);

} // namespace espalier

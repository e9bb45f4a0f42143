// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Grid.h"
#include "model/tree/StrandProfile.h"

#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Profiles between two: by outlines, if both have as many parts and cavities, which are matched by their
/// places, resampled by arc length and blended point by point; else, or where that would cross, by distances:
/// the outline of the blended distances from both boundaries. So a part divides, and a cavity or the mouth of
/// a C closes, at some place between. Attractors are blended in their order; those that only one has are in
/// the nearer half.
class ProfileBlend {
public:
    enum class By { Outlines, Distances };
    /// Precondition: neither profile has a fault.
    ProfileBlend(StrandProfile from, StrandProfile to, By by = By::Outlines);

    /// The first profile for a share of 0, the other one for 1. It has no fault.
    StrandProfile at(float share) const;

private:
    /// Two lines of as many points, which start at places that belong together.
    struct Pair {
        StrandProfile::Loop from;
        StrandProfile::Loop to;
    };
    /// Distances from both boundaries at the nodes of a grid, positive inside.
    struct Distances {
        Grid<float> from;
        Grid<float> to;
        Vec2 corner = Vec2::Zero();
        float spacing = 1.0F;
    };
    static std::vector<Pair> matched(const std::vector<StrandProfile::Loop>& from,
                                     std::vector<StrandProfile::Loop> to);
    Distances distances() const;
    static StrandProfile blended(const Distances& distances, float share);

    StrandProfile m_from;
    StrandProfile m_to;
    std::vector<Pair> m_pairs;            ///< None if the blend is by distances
    std::optional<Distances> m_distances; ///< Made at once where there are no pairs
};

/// The outline that a hand-drawn line means: its ends are joined, it is smoothed, and points that its form
/// does not need are left out. A loop of 3 to some 60 points, which may cross itself; empty for a line that
/// is shorter than @p least from side to side.
StrandProfile::Loop sketchedLoop(std::span<const Vec2> stroke, float least);

} // namespace espalier

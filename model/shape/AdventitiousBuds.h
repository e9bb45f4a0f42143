// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <functional>
#include <vector>

namespace espalier {

/// Buds that old wood makes around a branch, in a spiral of the golden angle (Strands 2024 §5, figure 7): the
/// middle one is at the place that is given, and the others are below and above it along the axis.
struct BudSpiral {
    static constexpr int kMostBuds = 8;
    static constexpr double kGreatestSpacing = 1.0; ///< m

    InternodeId internode = 0;
    double along = 0.5; ///< Place of the middle bud: 0 at the internode's lower end, 1 at its node
    /// Of the middle bud around the internode, degrees, from its frame's +X toward +Z. Degrees, so that a
    /// record of it is exact.
    double azimuth = 0.0;
    int count = 5;        ///< 1...kMostBuds
    double spacing = 0.0; ///< Between two buds, along the axis, m, 0...kGreatestSpacing
};

/// A bud in the bark.
struct BarkBud {
    InternodeId internode; ///< That its branch is attached to
    float along;           ///< Where on that internode the branch is attached, 0...1
    Vec3 base;             ///< The same place in the world, on the internode's axis, m
    Vec3 place;            ///< Of the bud, on the bark, m
    Vec3 direction;        ///< From base to place, of unit length
};

/// What buds need to know of their surroundings.
struct BudSurroundings {
    std::function<float(InternodeId)> radius;  ///< Of the bark, m
    std::function<float(const Vec3&)> lightAt; ///< At a place, m, 0...1
    float reach = 0.1F;                        ///< How far a bud senses light, m
};

/// Places the buds of @p spiral: each looks along the normal of the bark, turned some way to the light. An
/// axis that is too short for the spacing has them closer together. Buds that would be below the ground are
/// left out. None if the internode is dead or unknown.
std::vector<BarkBud> placeBuds(const Tree& tree, const TreeIndex& index, const BudSpiral& spiral,
                               const BudSurroundings& surroundings);

/// Makes @p buds: each is an internode from the axis of the wood to the bark, whose terminal bud is active,
/// so that it competes as other buds do and grows into a branch. It takes one step of time, so that buds that
/// come to the same place later have other keys. Precondition: @p buds are those of placeBuds().
TreeDelta addBuds(const Tree& tree, const TreeIndex& index, const std::vector<BarkBud>& buds);

} // namespace espalier

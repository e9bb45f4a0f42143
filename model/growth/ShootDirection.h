// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "model/growth/GrowingTree.h"
#include "model/growth/VoxelSpace.h"

namespace espalier {

/// The unit vector @p heading, turned by @p share of its angle to the unit vector @p target; a negative
/// share turns it away. Unchanged if the two are parallel.
Vec3 turnedToward(const Vec3& heading, const Vec3& target, double share);

/// The unit vector toward the light at @p position, m: the mean of directions of the upper half ball, each
/// weighted by the light that a node some voxels away in that direction would have.
Vec3 lightDirection(const VoxelSpace& space, const Vec3& position);

/// The direction of the internode that grows from @p bud by the vigour model, a unit vector: the bud's, with
/// the random turn of the axis or the horizontal tropism of a new lateral, then turned by gravitropism and
/// phototropism. Below 0, gravitropism turns branches down, but the trunk up. @p order of the new internode's
/// axis.
Vec3 shootDirection(const GrowingTree& growing, const VoxelSpace& space, const VigourParameters& parameters,
                    const BudRef& bud, int order);

/// The roll of the internode that grows from @p bud, rad, as in GrowingTree::grow(). Single buds stand in a
/// spiral, several at a node in the gaps of the node before.
double shootRoll(const GrowingTree& growing, const VigourParameters& parameters, const BudRef& bud);

} // namespace espalier

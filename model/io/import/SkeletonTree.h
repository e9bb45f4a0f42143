// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/import/Skeleton.h"
#include "model/tree/Tree.h"

namespace espalier {

/// The edit that makes the trees of a skeleton out of the seedling that @p tree consists of (precondition:
/// tree.size() == 1). The thickest foot moves to the world's origin, and all others with it; the lowest foot
/// stands on the ground.
///
/// Each segment becomes an internode, which ends where the segment does and begins at the nearest place on
/// the internode that carries it: a measured branch begins at the surface of the wood below it. Segments
/// without a length are left out. The thickest branch at a node's end continues the axis. Measured radii
/// become width constraints. The tips get the buds that grown ones have; there are no buds on the wood below.
///
/// Fails (Kind::Input) if no segment has a length, or if one would be too long or stand too far away.
Result<TreeDelta> growSkeleton(const Tree& tree, const Skeleton& skeleton);

} // namespace espalier

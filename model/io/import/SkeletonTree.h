// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/import/Skeleton.h"
#include "model/sketch/LeafPlacement.h"
#include "model/tree/Tree.h"

#include <span>

namespace espalier {

/// A leaf of a skeleton.
struct SkeletonLeaf {
    std::uint32_t segment = 0; ///< That carries it
    Vec3 base = Vec3::Zero();  ///< m
    LeafBlade blade;
};

/// The edit that makes the trees of a skeleton out of the seedling that @p tree consists of (precondition:
/// tree.size() == 1). The thickest foot moves to the world's origin, and all others with it; the lowest foot
/// stands on the ground.
///
/// Each segment becomes an internode, which ends where the segment does and begins at the nearest place on
/// the internode that carries it: a measured branch begins at the surface of the wood below it. Segments
/// without a length are left out. The thickest branch at a node's end continues the axis. Measured radii
/// become width constraints. The tips get the buds that grown ones have; there are no buds on the wood below.
/// Leaves become placed leaves, each at the place of its segment's internode that is nearest to its base.
///
/// Fails (Kind::Input) if no segment has a length, or if one would be too long or stand too far away.
Result<TreeDelta> growSkeleton(const Tree& tree, const Skeleton& skeleton,
                               std::span<const SkeletonLeaf> leaves = {});

} // namespace espalier

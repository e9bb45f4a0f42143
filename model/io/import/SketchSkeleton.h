// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/import/SkeletonTree.h"
#include "model/sketch/DepthInference.h"

namespace espalier {

/// The wood of a drawn tree as the segments that growSkeleton() makes internodes of. Each branch is divided
/// into pieces as curvePieces() does, about @p internodeLength (m, > 0) long, or longer if the tree had more
/// than kMostSegments pieces otherwise. A branch begins at the piece that carries it, `along` its length.
/// Where two sides were drawn, a piece has the radius that they have at its end, at most kGreatestDiameter /
/// 2; elsewhere the radius is 0, so it follows from what the wood carries (Okabe 2005, 3.2, has a default
/// form instead). Empty for a tree without branches.
Skeleton skeletonOf(const PlacedTree& tree, double internodeLength);

/// The leaves of that skeleton: blades as bladeOf() gives them, whose upper sides look at the viewer of the
/// drawing, or, in the second tree, to where the viewer has come by its turn. Leaves without a size are left
/// out.
std::vector<SkeletonLeaf> skeletonLeavesOf(const PlacedTree& tree, double internodeLength);

} // namespace espalier

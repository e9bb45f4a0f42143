// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/import/Skeleton.h"
#include "model/sketch/DepthInference.h"

namespace espalier {

/// The wood of a drawn tree as the segments that growSkeleton() makes internodes of. Each branch is divided
/// into pieces of equal length, about @p internodeLength (m, > 0) each, or longer ones if the tree had more
/// than kMostSegments pieces otherwise. A branch begins at the piece that carries it, `along` its length.
/// Where two sides were drawn, a piece has the radius that they have at its end, at most kGreatestDiameter /
/// 2; elsewhere the radius is 0, so it follows from what the wood carries (Okabe 2005, 3.2, has a default
/// form instead). Leaves are left out. Empty for a tree without branches.
Skeleton skeletonOf(const PlacedTree& tree, double internodeLength);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/sketch/SketchLine.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <cstdint>

namespace espalier {

/// Limbs whose tip cannot touch the hull, since they begin outside it, are shortened to this share of their
/// length.
inline constexpr double kShrunkLimb = 0.01;

/// The edit that gives a tree a new figure.
struct Reproduction {
    TreeDelta delta;           ///< Changes rotations and lengths alone; no step of time
    std::uint32_t outside = 0; ///< Branches that begin outside the hull, and so cannot end in it
};

/// The seedling's tree in another figure, with the same branches and internodes (reproduction, Okabe 2005,
/// 3.7 and 4.4). Other trees of the document stay as they are.
///
/// @p trunk: an open stroke of two points or more, the new trunk; its lower end is the base. It moves so that
/// the base is where the tree stands, and @p silhouette, three points or more, moves with it. Both in m, in
/// the plane of the drawing, right and up. @p azimuth: where the upright drawing is seen from, rad from +Z
/// toward +X.
///
/// The trunk follows its stroke: its internodes keep their shares of the length. All other internodes keep
/// their rotations and places on their parents, so a branch keeps its direction in the turtle's frame of the
/// trunk. The branches on the trunk, the limbs, get the length at which their tips touch the hull of the
/// silhouette, and all that a limb carries is scaled as the limb is; a branch whose tip would then be outside
/// ends at the hull. The hull is the circle swept along the silhouette's convex hull (CrownHull); unlike the
/// one for drawings it is not enlarged, so that the tree fits into the stroke that the user sees.
///
/// Widths and placed leaves do not change. The trunk may reach out of the hull, and so may the bows of curved
/// branches; tips do not, apart from those of branches that begin outside.
///
/// Fails (Kind::Input) if the trunk has no length or the silhouette no area, or if an internode would become
/// longer than kGreatestLength or lie farther away than kFarthestNode.
Result<Reproduction> reproduced(const Tree& tree, const TreeIndex& index, const SketchLine& trunk,
                                const SketchLine& silhouette, double azimuth = 0.0);

} // namespace espalier

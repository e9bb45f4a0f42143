// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/picking/PickIndex.h"
#include "model/tree/TreeIndex.h"
#include "views/camera/Camera.h"
#include "views/input/PointerSample.h"

#include <functional>
#include <optional>

namespace espalier {

/// A place on a branch, under or near the pointer.
struct PickedBranch {
    InternodeId id = 0;
    float along = 1.0F;           ///< 0 at the internode's lower end, 1 at its node
    Vec3 position = Vec3::Zero(); ///< On the branch's axis, m
    float radius = 0.0F;          ///< Radius of the branch there, m
};

/// The data that picking uses.
struct PickScene {
    const Tree& tree;
    const TreeIndex& index;
    const PickIndex& nodes; ///< After settle()
    /// Radius of the bark, m; never more than @p greatestRadius.
    const std::function<float(InternodeId)>& radius;
    float greatestRadius;
    const Camera& camera;
};

/// The living internode whose bark appears nearest to @p screen, at most @p reach px away; of internodes at
/// practically the same distance, the one in front. Reads only the cells near the ray.
std::optional<PickedBranch> pickBranch(const PickScene& scene, const QPointF& screen, double reach);

/// The same for tools that work on thick wood: of the branches under @p screen, those that are drawn less
/// than two thirds as wide as another one with more strands are passed over, although they may be in front of
/// it. So twigs before a trunk do not hide it. Of the thick branch, the internode beside the pointer.
std::optional<PickedBranch> pickThickBranch(const PickScene& scene, const QPointF& screen, double reach);

/// The place on the axis of @p picked that appears nearest to @p screen. On thick wood, several internodes
/// are under the pointer, and pickBranch() takes one of them; this is the one beside the pointer.
PickedBranch nearestOnAxis(const Tree& tree, const TreeIndex& index, const Camera& camera,
                           PickedBranch picked, const QPointF& screen);

/// The distance within which a pointer picks: 8 mm for a finger, less for a pen or a mouse; px.
/// @param pixelsPerMillimetre of the screen, device-independent
double pickReach(PointerDevice device, double pixelsPerMillimetre);

} // namespace espalier

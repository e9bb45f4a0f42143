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
    Vec3 position = Vec3::Zero(); ///< On its axis, m
    float radius = 0.0F;          ///< Of the branch there, m
};

/// What a pointer can be asked to pick from.
struct PickScene {
    const Tree& tree;
    const TreeIndex& index;
    const PickIndex& nodes;                          ///< Settled
    const std::function<float(InternodeId)>& radius; ///< Of the bark, m; never more than @p greatestRadius
    float greatestRadius;
    const Camera& camera;
};

/// The living internode whose bark appears nearest to @p screen, at most @p reach px away; of those as near
/// as makes no difference, the one in front. Looks into the cells that lie on the way alone.
std::optional<PickedBranch> pickBranch(const PickScene& scene, const QPointF& screen, double reach);

/// How near a pointer must come to what it picks: 8 mm for a finger, less for a pen or a mouse; px.
/// @param pixelsPerMillimetre of the screen, device-independent
double pickReach(PointerDevice device, double pixelsPerMillimetre);

} // namespace espalier

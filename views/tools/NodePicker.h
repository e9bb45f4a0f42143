// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"
#include "views/camera/Camera.h"

#include <optional>

namespace espalier {

/// The living node that appears nearest to @p screen, at most @p reach px away; of those as near as makes
/// no difference, the one nearest to the camera. The base of the seedling counts as a node of internode 0.
struct PickedNode {
    InternodeId id = 0;
    Vec3 position = Vec3::Zero(); ///< m
};
std::optional<PickedNode> pickNode(const Tree& tree, const TreeIndex& index, const Camera& camera,
                                   const QPointF& screen, double reach);

} // namespace espalier

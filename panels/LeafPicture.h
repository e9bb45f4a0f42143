// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/BranchPlace.h"
#include "model/tree/TreeIndex.h"

#include <QImage>

namespace espalier {

/// How a picture of a branch is made.
struct LeafPictureStyle {
    Vec3 right = Vec3::UnitX(); ///< Of the viewer, unit
    Vec3 up = Vec3::UnitY();    ///< Of the viewer, unit
    int edge = 96;              ///< px, device-independent, of the square
    qreal pixelRatio = 1.0;
};

/// A picture of the axis that @p branch is on, with what it carries and the placed leaves that it would have
/// after @p suggestion, which starts at @p tree: leaves that it adds or moves are in the accent colour. It is
/// seen without perspective from where the viewer stands, or, where the branch points at the viewer, from a
/// place beside it. Pictures of the same branch have the same scale. Of what the branch carries, at most
/// 2,000 internodes are drawn. Precondition: @p branch is alive.
QImage leafPicture(const Tree& tree, const TreeIndex& index, InternodeId branch, const TreeDelta& suggestion,
                   const LeafPictureStyle& style);

} // namespace espalier

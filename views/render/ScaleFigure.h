// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"

#include <QRect>

class QPainter;

namespace espalier {

inline constexpr double kPersonHeight = 1.75; ///< m

/// How far to the right of the seedling a person stands beside a tree within @p bounds, m: beside a low
/// crown, and under a high one.
float personPlace(const Box3& bounds);

/// Draws the silhouette of a person who stands on the ground beside the seedling, @p right metres to the
/// right as the camera sees it, and writes its height. It fades where it would be larger than the view or is
/// seen from above.
void paintPerson(QPainter& painter, const Camera& camera, float right, bool isOverLight);

/// The length that a scale bar of at most @p most metres shows: round in the units in force.
double scaleBarLength(double most);

/// Draws a scale bar in the lower right corner of @p clear, px, for lengths at the seedling.
void paintScaleBar(QPainter& painter, const Camera& camera, const QRect& clear, bool isOverLight);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"
#include "views/render/Overlay.h"

#include <QFontMetricsF>
#include <QRectF>

#include <vector>

namespace espalier {

/// The boxes in which the labels of @p overlay are painted, px, in their order: beside their points, and
/// below other labels that would be covered. Null for a label whose point is not before the camera.
std::vector<QRectF> labelBoxes(const Overlay& overlay, const Camera& camera, const QFontMetricsF& metrics);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"
#include "views/render/Overlay.h"

namespace espalier {

/// Time that the rings expand which confirm a bud's selection (TreeSketch §3.2), s.
inline constexpr double kRingsExpand = 1.2;

/// Shows which bud alone grows: rings that expand while the selection is new, then one that stays.
/// @param age since the selection, s
void paintSelectionRings(Overlay& overlay, const Camera& camera, const Vec3& position, double age);

} // namespace espalier

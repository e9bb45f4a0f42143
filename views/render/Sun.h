// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "views/camera/Camera.h"

namespace espalier {

/// Unit vector toward the sun; a pinned sun turns with the camera.
Vec3 towardSun(const ViewValues& view, const Camera& camera);

/// Moves the sun to the direction @p toward (unit), or to the nearest direction above the horizon. Straight
/// above, the azimuth does not change.
void putSun(ViewValues& view, const Camera& camera, const Vec3& toward);

/// Pins or unpins the sun without moving it.
void pinSun(ViewValues& view, const Camera& camera, bool pinned);

} // namespace espalier

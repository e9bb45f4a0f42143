// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "views/camera/Camera.h"

namespace espalier {

/// Unit vector toward the sun; a pinned one goes about with the camera.
Vec3 towardSun(const ViewValues& view, const Camera& camera);

/// Puts the sun into direction @p toward (unit), or as near to it as the horizon lets it come. Straight
/// above, it keeps its azimuth.
void putSun(ViewValues& view, const Camera& camera, const Vec3& toward);

/// Pins the sun or lets it go; either leaves it where it is.
void pinSun(ViewValues& view, const Camera& camera, bool pinned);

} // namespace espalier

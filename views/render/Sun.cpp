// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/Sun.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

double cameraShare(const ViewValues& view, const Camera& camera)
{
    return view.sunPinned ? static_cast<double>(camera.azimuth()) : 0.0;
}

/// The same angle, −π...π.
double wrapped(double angle)
{
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

} // namespace

Vec3 towardSun(const ViewValues& view, const Camera& camera)
{
    const double azimuth = view.sunAzimuth + cameraShare(view, camera);
    const double level = std::cos(view.sunElevation);
    return Vec3(static_cast<float>(level * std::sin(azimuth)),
                static_cast<float>(std::sin(view.sunElevation)),
                static_cast<float>(level * std::cos(azimuth)))
        .normalized();
}

void putSun(ViewValues& view, const Camera& camera, const Vec3& toward)
{
    const auto x = static_cast<double>(toward.x());
    const auto y = static_cast<double>(toward.y());
    const auto z = static_cast<double>(toward.z());
    const double level = std::hypot(x, z);
    view.sunElevation = std::max(std::atan2(y, level), kLeastSunElevation);
    if (level > 1e-4)
        view.sunAzimuth = wrapped(std::atan2(x, z) - cameraShare(view, camera));
}

void pinSun(ViewValues& view, const Camera& camera, bool pinned)
{
    const double before = cameraShare(view, camera);
    view.sunPinned = pinned;
    view.sunAzimuth = wrapped(view.sunAzimuth + before - cameraShare(view, camera));
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"

namespace espalier {

/// A short, smooth move of the camera from one view to another; it turns the short way round.
class CameraFlight {
public:
    static constexpr double kDuration = 0.35; ///< s

    void start(const Camera& from, const Camera& to);
    void stop() { m_elapsed = kDuration; }
    /// Where the last flight ends, or ended.
    const Camera& end() const { return m_to; }
    bool isFlying() const { return m_elapsed < kDuration; }
    /// Turns a flight under way, with its beginning and its end, rad.
    void orbit(float byAzimuth, float byElevation)
    {
        m_from.orbit(byAzimuth, byElevation);
        m_to.orbit(byAzimuth, byElevation);
    }

    /// Moves @p camera on by @p seconds; it reaches the exact end. The view size does not change.
    void advance(Camera& camera, double seconds);

private:
    Camera m_from;
    Camera m_to;
    double m_elapsed = kDuration;
};

} // namespace espalier

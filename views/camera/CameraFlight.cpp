// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/camera/CameraFlight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

void CameraFlight::start(const Camera& from, const Camera& to)
{
    m_from = from;
    m_to = to;
    const float turn = std::remainder(to.azimuth() - from.azimuth(), 2.0F * std::numbers::pi_v<float>);
    m_to.setAzimuth(from.azimuth() + turn);
    m_elapsed = 0.0;
}

void CameraFlight::advance(Camera& camera, double seconds)
{
    m_elapsed = std::min(m_elapsed + seconds, kDuration);
    const auto time = static_cast<float>(m_elapsed / kDuration);
    const float eased = time * time * (3.0F - 2.0F * time);
    camera.setTarget(m_from.target() + eased * (m_to.target() - m_from.target()));
    // Linear in the logarithm, so that the picture grows or shrinks at an even rate.
    camera.setDistance(m_from.distance() * std::pow(m_to.distance() / m_from.distance(), eased));
    camera.setAzimuth(std::lerp(m_from.azimuth(), m_to.azimuth(), eased));
    camera.setElevation(std::lerp(m_from.elevation(), m_to.elevation(), eased));
    camera.setTargetShare(m_from.targetShare() +
                          static_cast<double>(eased) * (m_to.targetShare() - m_from.targetShare()));
}

} // namespace espalier

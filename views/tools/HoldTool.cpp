// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/HoldTool.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// The longest step of the gesture's clock, s: where growth cannot keep up, the gesture slows down and the
/// program does not.
constexpr double kLongestHoldStep = 0.1;
/// Of the rings, px: the radius of the smallest, and of the largest.
constexpr double kLeastHoldRing = 8.0;
constexpr double kGreatestHoldRing = 46.0;
constexpr int kHoldRings = 3;
/// A ring goes all the way in this time, s.
constexpr double kRingPeriod = 1.2;

} // namespace

void HoldTool::begin(const PointerSample& sample)
{
    aim(sample);
    if (!m_picked)
        return;
    m_gesture = makeGesture(context().document(), m_picked->id);
    m_lastTime = sample.time;
    m_heldTime = 0.0;
}

void HoldTool::tick(double now)
{
    if (!m_gesture)
        return;
    m_heldTime += std::clamp(now - m_lastTime, 0.0, kLongestHoldStep);
    m_lastTime = now;
    m_gesture->holdTo(m_heldTime);
    context().requestRepaint();
}

void HoldTool::end(const PointerSample& sample)
{
    tick(sample.time);
    finish();
}

void HoldTool::finish()
{
    if (m_gesture)
        m_gesture->finish();
    stop();
}

void HoldTool::cancel()
{
    if (m_gesture)
        m_gesture->cancel();
    stop();
}

void HoldTool::stop()
{
    m_gesture.reset();
    leave();
}

void HoldTool::hover(const PointerSample& sample)
{
    aim(sample);
}

void HoldTool::leave()
{
    m_picked.reset();
    context().requestRepaint();
}

void HoldTool::aim(const PointerSample& sample)
{
    m_picked = context().pickThick(sample.position, sample.device);
    context().requestRepaint();
}

void HoldTool::paint(Overlay& overlay) const
{
    const TreeDocument& document = context().document();
    // An undo takes away what the pointer hovers over.
    if (!m_picked || !document.tree().isAlive(m_picked->id))
        return;
    const Camera& camera = context().camera();
    // The branch moves while it grows.
    const Vec3& place = m_gesture ? document.index().nodePosition(m_picked->id) : m_picked->position;
    const float pixels = camera.pixelsPerMetre(camera.depth(place));
    const auto bark = static_cast<double>(context().branchRadius(m_picked->id) * pixels);
    const auto ring = [&](double radius, double opacity) {
        QColor colour = ringColour();
        colour.setAlphaF(static_cast<float>(opacity));
        overlay.addCircle(place, camera.right(), camera.up(), static_cast<float>(bark + radius) / pixels,
                          colour, 2.0F);
    };
    ring(kLeastHoldRing, 1.0);
    if (!m_gesture)
        return;
    for (int i = 0; i < kHoldRings; ++i) {
        const double turns = m_heldTime / kRingPeriod - static_cast<double>(i) / kHoldRings;
        if (turns < 0.0)
            continue;
        const double part = turns - std::floor(turns);
        const double way = ringsGrow() ? part : 1.0 - part;
        ring(std::lerp(kLeastHoldRing, kGreatestHoldRing, way), 1.0 - way);
    }
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/StrokeStabiliser.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// A stroke that is nearer than this to its aim, px, has arrived.
constexpr double kArrived = 0.25;

double lengthOf(const QPointF& vector)
{
    return std::hypot(vector.x(), vector.y());
}

} // namespace

void StrokeStabiliser::begin(const PointerSample& sample)
{
    m_last = sample;
    m_pulled = sample.position;
    m_at = sample.position;
    m_reached = sample.time;
}

PointerSample StrokeStabiliser::move(const PointerSample& sample)
{
    m_last = sample;
    const QPointF string = sample.position - m_pulled;
    if (const double length = lengthOf(string); length > m_stabilising.distance)
        m_pulled += (1.0 - m_stabilising.distance / length) * string;
    return approach();
}

std::optional<PointerSample> StrokeStabiliser::rest(double time)
{
    if (lengthOf(m_pulled - m_at) < kArrived)
        return {};
    m_last.time = std::max(m_last.time, time);
    return approach();
}

/// Takes the stroke toward the stone: the rest of the way shrinks to 1/e in each delay.
PointerSample StrokeStabiliser::approach()
{
    const double passed = m_last.time - m_reached;
    const double share = m_stabilising.delay > 0.0 ? 1.0 - std::exp(-passed / m_stabilising.delay) : 1.0;
    m_at += share * (m_pulled - m_at);
    m_reached = m_last.time;
    PointerSample sample = m_last;
    sample.position = m_at;
    return sample;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/PointerReader.h"

#include "model/base/Vector.h"

#include <QInputDevice>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTouchEvent>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// The longest time that an event is assumed to have waited in the queue, s.
constexpr double kLongestDelay = 0.25;
/// During a stroke its pace counts: the same, where its first event waited longer than those that follow.
constexpr double kLongestLead = 3.0;
/// Events that were made longer than this, s, before a rest arrive before it.
constexpr double kMostLateness = 0.1;
/// A rest is noted in parts no longer than this, s: events that wait arrive in between.
constexpr double kLongestRest = 0.05;

PointerPhase phaseOf(QEventPoint::State state)
{
    switch (state) {
    case QEventPoint::State::Pressed:
        return PointerPhase::Press;
    case QEventPoint::State::Released:
        return PointerPhase::Release;
    default:
        return PointerPhase::Move;
    }
}

} // namespace

PointerReader::PointerReader()
{
    m_timer.start();
}

double PointerReader::now() const
{
    return static_cast<double>(m_timer.nsecsElapsed()) * 1e-9;
}

double PointerReader::rest()
{
    m_rested = std::max(m_rested, std::min(now(), std::max(m_rested, m_last) + kLongestRest));
    return m_rested;
}

/// The timestamps of events that waited in the queue are right, so that a stroke keeps its pace, however busy
/// the program is; but their clock can have any origin, and synthetic events can have any time.
double PointerReader::timeOf(quint64 timestamp)
{
    const double arrived = now();
    const double stamped = static_cast<double>(timestamp) * 1e-3;
    const double earliest = std::max(m_last, m_isDown ? m_rested - kMostLateness : arrived - kLongestDelay);
    const double latest = m_isDown ? arrived + kLongestLead : arrived;
    const double assumed = stamped + m_offset;
    if (assumed > latest || (!m_isDown && assumed < earliest))
        m_offset = std::max(arrived, earliest) - stamped;
    m_last = std::max(earliest, stamped + m_offset);
    return m_last;
}

std::span<const PointerSample> PointerReader::read(QEvent& event)
{
    m_samples.clear();
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: // Quick strokes arrive as double clicks.
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        readMouse(static_cast<const QMouseEvent&>(event));
        break;
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        readTouch(static_cast<const QTouchEvent&>(event));
        break;
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        readTablet(static_cast<const QTabletEvent&>(event));
        break;
    default:
        break;
    }
    return m_samples;
}

void PointerReader::readMouse(const QMouseEvent& event)
{
    if (event.source() != Qt::MouseEventNotSynthesized)
        return;
    PointerSample sample;
    if (event.type() == QEvent::MouseButtonRelease)
        sample.phase = PointerPhase::Release;
    else if (event.type() != QEvent::MouseMove)
        sample.phase = PointerPhase::Press;
    else
        sample.phase = event.buttons() == Qt::NoButton ? PointerPhase::Hover : PointerPhase::Move;
    sample.position = event.position();
    sample.time = timeOf(event.timestamp());
    sample.button = event.button();
    sample.buttons = event.buttons();
    sample.modifiers = event.modifiers();
    m_samples.push_back(sample);
    m_isDown = event.buttons() != Qt::NoButton;
}

void PointerReader::readTouch(const QTouchEvent& event)
{
    const bool cancelled = event.type() == QEvent::TouchCancel;
    const bool hasPressure =
        event.device() != nullptr && event.device()->hasCapability(QInputDevice::Capability::Pressure);
    const double time = timeOf(event.timestamp());
    m_isDown = event.type() != QEvent::TouchEnd && !cancelled;
    for (const QEventPoint& point : event.points()) {
        if (point.state() == QEventPoint::State::Stationary && !cancelled)
            continue;
        PointerSample sample;
        sample.id = point.id();
        sample.device = PointerDevice::Finger;
        sample.phase = cancelled ? PointerPhase::Cancel : phaseOf(point.state());
        sample.position = point.position();
        sample.pressure =
            hasPressure ? std::pow(std::clamp(point.pressure(), 0.0, 1.0), m_pressureExponent) : 1.0;
        sample.time = time;
        sample.modifiers = event.modifiers();
        m_samples.push_back(sample);
    }
    // If the system takes the touch away, the event has no points.
    if (cancelled && m_samples.empty()) {
        PointerSample all;
        all.id = PointerSample::kAllFingers;
        all.device = PointerDevice::Finger;
        all.phase = PointerPhase::Cancel;
        all.time = time;
        m_samples.push_back(all);
    }
}

void PointerReader::readTablet(const QTabletEvent& event)
{
    PointerSample sample;
    sample.device = PointerDevice::Pen;
    if (event.type() == QEvent::TabletPress)
        sample.phase = PointerPhase::Press;
    else if (event.type() == QEvent::TabletRelease)
        sample.phase = PointerPhase::Release;
    else
        sample.phase = event.buttons() == Qt::NoButton ? PointerPhase::Hover : PointerPhase::Move;
    sample.position = event.position();
    sample.pressure = std::pow(std::clamp(event.pressure(), 0.0, 1.0), m_pressureExponent);
    sample.tilt = {radians(event.xTilt()), radians(event.yTilt())};
    sample.time = timeOf(event.timestamp());
    sample.button = event.button();
    sample.buttons = event.buttons();
    sample.modifiers = event.modifiers();
    sample.isEraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
    m_samples.push_back(sample);
    m_isDown = event.buttons() != Qt::NoButton;
}

} // namespace espalier

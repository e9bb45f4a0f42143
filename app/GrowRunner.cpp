// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/GrowRunner.h"

#include <limits>

namespace espalier {

GrowRunner::GrowRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &GrowRunner::step);
}

void GrowRunner::begin()
{
    start(std::numeric_limits<int>::max(), static_cast<int>(1000.0 / kStepsPerSecond));
}

void GrowRunner::run(int steps)
{
    start(steps, 0);
}

void GrowRunner::start(int steps, int interval)
{
    if (isRunning())
        return;
    m_gesture = std::make_unique<GrowGesture>(m_document, m_document.competitors());
    m_stepsLeft = steps;
    m_timer.start(interval);
    Q_EMIT runningChanged(true);
    step();
}

void GrowRunner::step()
{
    if (!m_gesture->step()) {
        end();
        Q_EMIT exhausted();
    } else if (--m_stepsLeft == 0) {
        end();
    }
}

void GrowRunner::end()
{
    if (!isRunning())
        return;
    m_timer.stop();
    const auto gesture = std::move(m_gesture);
    gesture->finish();
    Q_EMIT runningChanged(false);
}

void GrowRunner::cancel()
{
    if (!isRunning())
        return;
    m_timer.stop();
    m_gesture.reset();
    Q_EMIT runningChanged(false);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/LassoRunner.h"

namespace espalier {

LassoRunner::LassoRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(static_cast<int>(1000.0 / kStepsPerSecond));
    connect(&m_timer, &QTimer::timeout, this, &LassoRunner::step);
}

void LassoRunner::fill(const LassoStroke& stroke)
{
    end();
    start(LassoGesture::fill(m_document, stroke, m_document.competitors()));
}

void LassoRunner::regrow()
{
    end();
    start(LassoGesture::regrow(m_document));
}

void LassoRunner::start(LassoGesture::Begun begun)
{
    if (!begun) {
        Q_EMIT refused(begun.error().message);
        return;
    }
    m_gesture = std::move(*begun);
    m_timer.start();
    Q_EMIT runningChanged(true);
}

void LassoRunner::step()
{
    if (!m_gesture->step())
        end();
}

void LassoRunner::end()
{
    if (!isRunning())
        return;
    m_timer.stop();
    const auto gesture = std::move(m_gesture);
    gesture->finish();
    Q_EMIT runningChanged(false);
}

void LassoRunner::cancel()
{
    if (!isRunning())
        return;
    m_timer.stop();
    m_gesture.reset();
    Q_EMIT runningChanged(false);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/TimeRunner.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr int kFrame = 40; ///< ms
/// The greatest number of frames of a film.
constexpr std::size_t kMostFrames = 250;

} // namespace

TimeRunner::TimeRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&m_timer, &QTimer::timeout, this, &TimeRunner::showNext);
}

void TimeRunner::begin()
{
    if (m_gesture)
        return;
    m_gesture = std::make_unique<TimeGesture>(m_document, [this] { release(); });
    Q_EMIT runningChanged(true);
}

void TimeRunner::moveTo(int position)
{
    m_timer.stop();
    begin();
    m_gesture->moveTo(static_cast<std::size_t>(std::max(position, 0)));
}

void TimeRunner::release()
{
    m_timer.stop();
    if (!m_gesture)
        return;
    m_gesture->finish();
    m_gesture.reset();
    Q_EMIT runningChanged(false);
}

void TimeRunner::play()
{
    m_timer.start(kFrame);
    begin();
    if (m_document.future().empty())
        m_gesture->moveTo(0);
    m_stride = m_document.future().size() / kMostFrames + 1;
}

void TimeRunner::showNext()
{
    m_gesture->moveTo(std::min(m_document.journal().size() + m_stride, m_gesture->historyLength()));
    if (m_document.future().empty())
        release();
}

void TimeRunner::cancel()
{
    m_timer.stop();
    if (!m_gesture)
        return;
    m_gesture->cancel();
    m_gesture.reset();
    Q_EMIT runningChanged(false);
}

} // namespace espalier

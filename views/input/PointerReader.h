// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/input/PointerSample.h"

#include <QElapsedTimer>
#include <QEvent>

#include <span>
#include <vector>

class QMouseEvent;
class QTabletEvent;
class QTouchEvent;

namespace espalier {

/// Converts mouse, touch and tablet events to PointerSamples. Touch events are read directly, because Qt's
/// gestures lose or double moves. Mouse events that the system makes from touch or pen events are dropped,
/// because the original events arrive too.
class PointerReader {
public:
    PointerReader();

    /// Converts @p event to samples, one for each point that has changed; none if it is not an event of a
    /// pointer. Valid until the next call.
    std::span<const PointerSample> read(QEvent& event);
    /// Sets the exponent of pressure: samples have the measured pressure to this power. Below 1 a light hand
    /// is enough, above 1 a firm one is needed.
    void setPressureExponent(double exponent) { m_pressureExponent = exponent; }

    /// Time since the reader was made, s: the clock of all samples.
    double now() const;
    /// To be called between events, about 60 times a second while a pointer is down. Returns the time up to
    /// which pointers are known to be at rest, s, of the samples' clock: behind now() where events can still
    /// be waiting, because the program was busy.
    double rest();

private:
    void readMouse(const QMouseEvent& event);
    void readTouch(const QTouchEvent& event);
    void readTablet(const QTabletEvent& event);
    double timeOf(quint64 timestamp);

    QElapsedTimer m_timer;
    double m_offset = 0.0; ///< From the events' own clock to ours, s
    double m_last = 0.0;   ///< Time of the last sample, s
    double m_rested = 0.0; ///< Time of the last rest(), s
    bool m_isDown = false; ///< A button, a finger or the pen was down after the last event
    double m_pressureExponent = 1.0;
    std::vector<PointerSample> m_samples;
};

} // namespace espalier

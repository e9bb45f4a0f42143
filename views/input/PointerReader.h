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

/// Turns mouse, touch and tablet events into PointerSamples. Touch is read directly: Qt's own gestures lose
/// or double moves. Mouse events that the system makes up from touch or pen are dropped, for their
/// originals arrive as well.
class PointerReader {
public:
    PointerReader();

    /// What @p event says, one sample for each point that did something; empty if it is no event of a
    /// pointer. Valid until the next call.
    std::span<const PointerSample> read(QEvent& event);
    /// What is told of a pressure p is p to this power: below 1 a light hand suffices, above 1 it takes a
    /// firm one.
    void setPressureExponent(double exponent) { m_pressureExponent = exponent; }

    /// s since the reader was made: the clock of all samples.
    double now() const;

private:
    void readMouse(const QMouseEvent& event);
    void readTouch(const QTouchEvent& event);
    void readTablet(const QTabletEvent& event);
    double timeOf(quint64 timestamp);

    QElapsedTimer m_timer;
    double m_offset = 0.0; ///< From the events' own clock to ours, s
    double m_last = 0.0;
    double m_pressureExponent = 1.0;
    std::vector<PointerSample> m_samples;
};

} // namespace espalier

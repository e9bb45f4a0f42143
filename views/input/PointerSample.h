// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <Qt>

namespace espalier {

enum class PointerDevice { Mouse, Finger, Pen };

enum class PointerPhase {
    Press,
    Move,
    Release,
    Cancel, ///< The system took the pointer away
    Hover,  ///< Moves without touching, or without a button
};

/// What one finger, pen or mouse did at a moment: the one form that input takes here, whatever it came from.
struct PointerSample {
    /// The id of a sample that is about every finger on the screen.
    static constexpr int kAllFingers = -1;

    int id = 0; ///< Tells the fingers of one hand apart
    PointerDevice device = PointerDevice::Mouse;
    PointerPhase phase = PointerPhase::Hover;
    QPointF position;                      ///< Device-independent pixels from the view's upper left corner
    double pressure = 1.0;                 ///< 0...1; 1 of devices that do not measure it
    QPointF tilt;                          ///< Of a pen from upright toward right and down, rad
    double time = 0.0;                     ///< s, of PointerReader's clock; never runs back
    Qt::MouseButton button = Qt::NoButton; ///< That was pressed or released; a pen's tip is the left one
    Qt::MouseButtons buttons;              ///< Held
    Qt::KeyboardModifiers modifiers;
    bool isEraser = false; ///< The other end of a pen
};

} // namespace espalier

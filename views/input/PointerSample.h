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

/// The state of one finger, pen or mouse at a moment. All input has this form.
struct PointerSample {
    /// The id of a sample for all fingers on the screen.
    static constexpr int kAllFingers = -1;

    int id = 0; ///< Distinguishes the fingers
    PointerDevice device = PointerDevice::Mouse;
    PointerPhase phase = PointerPhase::Hover;
    QPointF position;      ///< Device-independent pixels from the view's upper left corner
    double pressure = 1.0; ///< 0...1; 1 of devices that do not measure it
    QPointF tilt;          ///< Tilt of a pen from upright toward right and down, rad
    double time = 0.0;     ///< s, of PointerReader's clock; never runs back
    /// The button that was pressed or released; a pen's tip is the left one.
    Qt::MouseButton button = Qt::NoButton;
    Qt::MouseButtons buttons; ///< The buttons that are held
    Qt::KeyboardModifiers modifiers;
    bool isEraser = false; ///< The pen's eraser end
};

} // namespace espalier

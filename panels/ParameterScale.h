// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"
#include "panels/ParameterTexts.h"

#include <optional>

namespace espalier {

/// The values that a parameter can have in the user interface: their order along a slider, the step between
/// shown values, the steps of the keys. All in ParameterInfo's surface unit. Lengths are shown in the units
/// that were in force when the scale was made.
class ParameterScale {
public:
    /// How much a key adds or subtracts.
    enum class Stride {
        Fine,   ///< The least difference that shows
        Normal, ///< A fiftieth of the slider's length
        Coarse, ///< A tenth of it
    };

    ParameterScale(const ParameterInfo& info, const ParameterText& text);
    /// The scale of the parameter of that key, which must exist.
    static ParameterScale of(const char* key);

    const ParameterInfo& info() const { return m_info; }
    const ParameterText& text() const { return m_text; }

    /// The value at @p place along the slider, 0...1; and the reverse.
    double at(double place) const;
    double placeOf(double value) const;
    /// The value as it is shown: within the limits, and without digits beyond those shown.
    double rounded(double value) const;
    /// The next value up (@p direction > 0) or down.
    double stepped(double value, int direction, Stride stride) const;
    /// The value after a key press: arrows step, finely with Shift; page keys step coarsely; Home and End go
    /// to the limits. Nothing for other keys.
    std::optional<double> keyed(double value, int key, Qt::KeyboardModifiers modifiers) const;
    /// The value with its unit, as it is shown.
    QString shown(double value) const;
    /// The unit as it follows a number, with a space before it if it needs one.
    QString suffix() const;
    /// Reads a text that the user has typed, within the limits: a length in any unit, another number with its
    /// unit or without. Nothing if it is not a number.
    std::optional<double> typed(const QString& text) const;

private:
    double grain() const; ///< Number of shown steps in a unit
    std::optional<double> parsed(const QString& number) const;

    ParameterInfo m_info;
    ParameterText m_text;
};

} // namespace espalier

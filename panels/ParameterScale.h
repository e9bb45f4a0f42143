// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"
#include "panels/ParameterTexts.h"

#include <optional>

namespace espalier {

/// The values that a parameter may have, as a person meets them: their order along a slider, the grain they
/// are shown with, the strides that keys make. All in ParameterInfo's surface unit. Lengths are shown in the
/// units in force when it was made.
class ParameterScale {
public:
    /// What a key adds or takes away.
    enum class Stride {
        Fine,   ///< The least that shows
        Normal, ///< A fiftieth of the slider's way
        Coarse, ///< A tenth of it
    };

    ParameterScale(const ParameterInfo& info, const ParameterText& text);
    /// Of the parameter of that key, which has to exist.
    static ParameterScale of(const char* key);

    const ParameterInfo& info() const { return m_info; }
    const ParameterText& text() const { return m_text; }

    /// The value at @p place of the way, 0...1; and the reverse.
    double at(double place) const;
    double placeOf(double value) const;
    /// What is shown is what is meant: within the limits, and no digits beyond those shown.
    double rounded(double value) const;
    /// The next value up (@p direction > 0) or down.
    double stepped(double value, int direction, Stride stride) const;
    /// What a key makes of a value, as on any slider: arrows stride, finely with Shift; page keys stride
    /// coarsely; home and end lead to the limits. Nothing for other keys.
    std::optional<double> keyed(double value, int key, Qt::KeyboardModifiers modifiers) const;
    /// The value with its unit, as it is shown.
    QString shown(double value) const;
    /// The unit as it follows a number: a space before it, or none.
    QString suffix() const;
    /// What a person means by a text, within the limits: a length in any unit, another number with its own or
    /// none. Nothing if it is no number.
    std::optional<double> typed(const QString& text) const;

private:
    double grain() const; ///< Steps of a unit
    std::optional<double> parsed(const QString& number) const;

    ParameterInfo m_info;
    ParameterText m_text;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace espalier {

/// How a person measures lengths; inside they are metres.
enum class Units { Metric, Imperial };

/// What lengths are written in, by the whole program. Metric at first. What is shown already keeps its texts.
Units units();
void setUnits(Units units);

/// A length as a person reads it, in the units in force: "0.42 cm", "42 cm", "1.25 m", or "1.7 in", "4 ft 1
/// in".
QString lengthText(double metres);

/// A number in the person's own notation, with a fixed number of decimals and no signs between thousands.
QString numberText(double number, int decimals);

/// What a person has typed: a decimal comma or point, "," and "." before it between thousands.
std::optional<double> parseNumber(const QString& text);

/// What a person has typed as a length, in whichever units: "12 cm", "0,3m", "5 ft 3 in", 5'3", "1 m 20".
/// A number without a unit is one of @p bareUnit, m. Returns m, or nothing if it is no length.
std::optional<double> parseLength(const QString& text, double bareUnit);

/// The nearest length that is round in the units in force, as a slider gives it: whole millimetres, or
/// twentieths of an inch.
double roundedLength(double metres);

inline constexpr double kInch = 0.0254; ///< m
inline constexpr double kFoot = 12.0 * kInch;

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace espalier {

/// The units in which lengths are shown and typed; the program calculates in metres.
enum class Units { Metric, Imperial };

/// The units of the whole program; metric by default. A change does not affect texts that are already on the
/// screen.
Units units();
void setUnits(Units units);

/// A length as text for the user, in the units in force: "0.42 cm", "42 cm", "1.25 m", or "1.7 in", "4 ft 1
/// in".
QString lengthText(double metres);

/// The same of a round length, with as few digits as it has: "2 m", "50 cm", "1.75 m".
QString roundLengthText(double metres);

/// A number in the user's locale, with a fixed number of decimals and no thousands separators.
QString numberText(double number, int decimals);

/// Reads a number that the user has typed: with a decimal comma or point, and "," or "." as thousands
/// separators.
std::optional<double> parseNumber(const QString& text);

/// Reads a length that the user has typed, in any units: "12 cm", "0,3m", "5 ft 3 in", 5'3", "1 m 20". A
/// number without a unit is multiplied by @p bareUnit, m. Returns m, or nothing if the text is not a length.
std::optional<double> parseLength(const QString& text, double bareUnit);

/// The nearest length that a slider can give, a round number in the units in force: whole millimetres, or
/// twentieths of an inch.
double roundedLength(double metres);

inline constexpr double kInch = 0.0254; ///< m
inline constexpr double kFoot = 12.0 * kInch;

} // namespace espalier

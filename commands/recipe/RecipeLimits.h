// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLatin1StringView>

/// The limits of a recipe as a whole. The limits of parameters are in visitParameters(), those of an
/// operation in its struct. resources/recipe.schema.json repeats all of them.
namespace espalier::recipeLimits {

/// The key whose value is the version of the format.
inline constexpr QLatin1StringView kVersionKey("espalier-recipe");
/// In recipes of version 1, parameters that are younger than it are off unless they are named.
inline constexpr int kVersion = 2;
inline constexpr double kCoordinate = 1000.0;    ///< m, for each axis and either sign
inline constexpr qsizetype kSamples = 1'000'000; ///< Of all strokes and lassos together
inline constexpr qsizetype kOperations = 100'000;
inline constexpr qsizetype kImages = 64; ///< Files
inline constexpr qsizetype kBytes = 64 << 20;
/// Recipes that are at most this long without spaces and line breaks, in bytes, are written with them.
inline constexpr qsizetype kIndentedBytes = 8 << 10;

} // namespace espalier::recipeLimits

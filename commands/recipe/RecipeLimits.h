// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLatin1StringView>

/// The limits of a recipe as a whole, beside those of the parameters (see visitParameters). The limits of one
/// operation stand with the operation. resources/recipe.schema.json repeats all of them.
namespace espalier::recipeLimits {

/// Its value is the version.
inline constexpr QLatin1StringView kVersionKey("espalier-recipe");
inline constexpr int kVersion = 1;
inline constexpr double kCoordinate = 1000.0;    ///< m, either way
inline constexpr qsizetype kSamples = 1'000'000; ///< Of all strokes and lassos together
inline constexpr qsizetype kOperations = 100'000;
inline constexpr qsizetype kImages = 64; ///< Files
inline constexpr qsizetype kBytes = 64 << 20;
/// Recipes that take up to so many bytes without spaces and line breaks are written with them.
inline constexpr qsizetype kIndentedBytes = 8 << 10;

} // namespace espalier::recipeLimits

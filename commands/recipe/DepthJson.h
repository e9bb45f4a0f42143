// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeReading.h"
#include "model/sketch/DepthInference.h"

#include <QJsonObject>

namespace espalier {

// JSON that the operations that infer depth have in common: "seed", "trees" (1 or 2), "sideways" ("all",
// "limbs" or "none"), and "hull", "length" and "angle", by which the limits of the drawing are multiplied.

inline constexpr double kLeastMagnification = 0.5;
inline constexpr double kGreatestMagnification = 3.0;

/// @p reader gets the errors.
DepthOptions readDepth(JsonReader& reader);
/// Adds what differs from the defaults.
void writeDepth(QJsonObject& json, const DepthOptions& options);

} // namespace espalier

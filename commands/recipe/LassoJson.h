// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeReading.h"
#include "model/tree/LassoStroke.h"

#include <QJsonObject>

#include <optional>

namespace espalier {

// JSON that all operations with strokes in a plane have in common.

inline constexpr qsizetype kLeastLassoPoints = 3;

/// Reads the members of a stroke in a plane: "origin", "right", "up" (each may be missing) and "points", at
/// least
/// @p least. @p reader gets the errors.
LassoStroke readLasso(JsonReader& reader, RecipeReading& reading, qsizetype least = kLeastLassoPoints);
/// The object from which readLasso() reads the same stroke.
QJsonObject lassoToJson(const LassoStroke& stroke);

/// The member "steps": the greatest number of growth steps, 0...kMostEnvelopeSteps; empty if it is missing.
std::optional<int> readSteps(JsonReader& reader);
void writeSteps(QJsonObject& json, std::optional<int> steps);
inline constexpr int kMostEnvelopeSteps = 10'000;

/// The stroke as a recipe has it: without negative zeros.
LassoStroke recordableLasso(LassoStroke stroke);

} // namespace espalier

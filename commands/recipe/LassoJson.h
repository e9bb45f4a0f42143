// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeReading.h"
#include "model/tree/LassoStroke.h"

#include <QJsonObject>

#include <optional>

namespace espalier {

// What the operations that fill envelopes have in common in JSON.

inline constexpr qsizetype kLeastLassoPoints = 3;

/// The members of a stroke of the lasso: "origin", "right", "up" (which may be missing) and "points",
/// kLeastLassoPoints or more. @p reader keeps what is wrong with them.
LassoStroke readLasso(JsonReader& reader, RecipeReading& reading);
/// An object that readLasso() turns into the same stroke.
QJsonObject lassoToJson(const LassoStroke& stroke);

/// The member "steps": the most growth steps that are made; nothing if it is missing.
std::optional<int> readSteps(JsonReader& reader);
void writeSteps(QJsonObject& json, std::optional<int> steps);
inline constexpr int kMostEnvelopeSteps = 10'000;

/// The stroke as a recipe keeps it: without negative zeros.
LassoStroke recordableLasso(LassoStroke stroke);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeReading.h"

#include <QJsonArray>

#include <vector>

namespace espalier {

/// Reads the points of a drawn stroke, [right, up] in m, one or more, each within ±recipeLimits::kCoordinate.
/// @p key: the member of @p reader's object that holds the stroke. @p place: where the stroke is, for errors,
/// which @p reader gets.
std::vector<Vec2> readStroke(JsonReader& reader, RecipeReading& reading, QLatin1StringView key,
                             const QString& place, const QJsonArray& array);
/// The array from which readStroke() reads the same stroke, except the sign of zeros.
QJsonArray strokeToJson(const std::vector<Vec2>& stroke);

} // namespace espalier

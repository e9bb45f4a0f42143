// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipeJson.h"

#include "commands/recipe/RecipeText.h"

#include <charconv>

namespace espalier {

double shortestDouble(float number)
{
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    double shortest = 0.0;
    std::from_chars(digits, end, shortest);
    // Rounding to double and then to float can give another float.
    return static_cast<float>(shortest) == number ? shortest : static_cast<double>(number);
}

Rotation readRotation(JsonReader& reader, QLatin1StringView key)
{
    const auto numbers = vectorFromJson<4>(reader.value(key).toArray(), 1.0);
    if (!numbers || !(numbers->norm() > 1e-3F)) {
        reader.fail(
            key,
            RecipeText::tr("a quaternion is expected: four numbers x, y, z, w within ±1, not all of them 0"));
        return Rotation::Identity();
    }
    const Rotation rotation((*numbers)[3], (*numbers)[0], (*numbers)[1], (*numbers)[2]);
    return faults::ofRotation(rotation) == nullptr ? rotation : Rotation(rotation.normalized());
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipeJson.h"

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

} // namespace espalier

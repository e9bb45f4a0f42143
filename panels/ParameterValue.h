// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

#include <string_view>
#include <type_traits>

namespace espalier {

/// The value of a parameter as a number in ParameterInfo's surface unit; switches and choices are 0, 1, 2...
template <class Field>
double surfaceValue(const ParameterInfo& info, const Field& field)
{
    if constexpr (std::is_same_v<Field, double>)
        return info.quantity == Quantity::Angle ? degrees(field) : field;
    else
        return static_cast<double>(field);
}

/// The reverse of surfaceValue().
template <class Field>
void setSurfaceValue(const ParameterInfo& info, Field& field, double value)
{
    if constexpr (std::is_same_v<Field, double>)
        field = info.quantity == Quantity::Angle ? radians(value) : value;
    else if constexpr (std::is_same_v<Field, bool>)
        field = value != 0.0;
    else
        field = static_cast<Field>(static_cast<int>(value));
}

/// Calls @p visit(info, field) for the parameter of that key.
template <class Parameters, class Visit>
void visitParameter(Parameters& parameters, std::string_view key, Visit&& visit)
{
    visitParameters(parameters, [&](const ParameterInfo& info, auto& field) {
        if (key == info.key)
            visit(info, field);
    });
}

} // namespace espalier

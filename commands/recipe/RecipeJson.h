// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/JsonReader.h"
#include "model/tree/TreeTables.h"

#include <QJsonArray>

#include <cmath>
#include <optional>

namespace espalier {

/// The double with the fewest digits that gives @p number when it is read as a float. Qt writes the fewest
/// digits that give the same double: it would write 0.1F as 0.10000000149011612.
double shortestDouble(float number);

/// The vector with 0 in place of -0, because JSON does not keep the sign of zeros.
template <int Count>
Eigen::Matrix<float, Count, 1> withoutNegativeZeros(Eigen::Matrix<float, Count, 1> vector)
{
    for (int i = 0; i < Count; ++i)
        vector[i] = vector[i] == 0.0F ? 0.0F : vector[i];
    return vector;
}

/// The elements of an array of exactly @p Count numbers, each within ±@p limit; empty for any other array.
template <int Count>
std::optional<Eigen::Matrix<float, Count, 1>> vectorFromJson(const QJsonArray& array, double limit)
{
    if (array.size() != Count)
        return std::nullopt;
    Eigen::Matrix<float, Count, 1> vector;
    for (int i = 0; i < Count; ++i) {
        if (!array.at(i).isDouble() || !(std::abs(array.at(i).toDouble()) <= limit))
            return std::nullopt;
        vector[i] = static_cast<float>(array.at(i).toDouble());
    }
    return vector;
}

/// The array from which vectorFromJson() reads the same vector, except the sign of zeros.
template <int Count>
QJsonArray toJson(const Eigen::Matrix<float, Count, 1>& vector)
{
    QJsonArray array;
    for (int i = 0; i < Count; ++i)
        array.append(shortestDouble(vector[i]));
    return array;
}

/// Reads a required rotation: a quaternion [x, y, z, w] of any length but 0; one whose length is nearly 1
/// stays as it is. @p reader gets the error if there is one.
Rotation readRotation(JsonReader& reader, QLatin1StringView key);

} // namespace espalier

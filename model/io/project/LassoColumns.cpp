// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/LassoColumns.h"

#include <algorithm>

namespace espalier {

LassoColumns LassoColumns::of(const Lassos& lassos)
{
    LassoColumns columns;
    for (const LassoStroke& stroke : lassos.strokes) {
        columns.origin.append(stroke.origin);
        columns.right.append(stroke.right);
        columns.up.append(stroke.up);
        columns.pointCount.append(static_cast<std::uint32_t>(stroke.points.size()));
        columns.inForce.append(0);
        for (const Vec2& point : stroke.points)
            columns.points.append(point);
    }
    for (const std::uint32_t index : lassos.inForce)
        columns.inForce[index] = 1;
    return columns;
}

std::optional<Lassos> LassoColumns::toLassos() const
{
    Lassos lassos;
    lassos.strokes.reserve(origin.size());
    qsizetype first = 0;
    for (qsizetype i = 0; i < origin.size(); ++i) {
        if (pointCount[i] > kMostLassoPoints || pointCount[i] > points.size() - first || inForce[i] > 1)
            return {};
        lassos.strokes.append(
            {origin[i], right[i], up[i], {points.begin() + first, points.begin() + first + pointCount[i]}});
        first += pointCount[i];
        if (inForce[i] != 0)
            lassos.inForce.push_back(static_cast<std::uint32_t>(i));
    }
    return first == points.size() ? std::optional(std::move(lassos)) : std::nullopt;
}

} // namespace espalier

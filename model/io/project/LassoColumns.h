// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

#include <QList>

#include <optional>

namespace espalier {

/// The lasso strokes that a tree has known, as columns: a row a stroke, then the points of all of them.
struct LassoColumns {
    QList<Vec3> origin;
    QList<Vec3> right;
    QList<Vec3> up;
    QList<std::uint32_t> pointCount;
    QList<std::uint8_t> inForce; ///< 0 or 1
    QList<Vec2> points;

    static LassoColumns of(const Lassos& lassos);
    /// Nothing if the counts do not add up to the points, or if a flag is none. Precondition: the columns
    /// are of the sizes that visit() says.
    std::optional<Lassos> toLassos() const;

    /// Calls @p visitor(name, column, rows) for each column, in a fixed order.
    template <class Self, class Visit>
    static void visit(Self& self, std::uint32_t strokes, std::uint32_t points, Visit&& visitor)
    {
        visitor("origin", self.origin, strokes);
        visitor("right", self.right, strokes);
        visitor("up", self.up, strokes);
        visitor("pointCount", self.pointCount, strokes);
        visitor("inForce", self.inForce, strokes);
        visitor("points", self.points, points);
    }
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Coverage.h"
#include "model/envelope/Grid.h"

#include <algorithm>
#include <span>
#include <vector>

namespace espalier {

/// A silhouette and how far it is inflated to both sides of its plane, in units of a grid's nodes.
struct EnvelopeField {
    /// Distance to the nearest outline: positive inside, negative outside. Exact inside and beside the
    /// outline.
    Grid<float> distance;
    /// Squared height of the surface above (and below) a node. Never less than distance² inside; falls
    /// through 0 on the outline.
    Grid<float> squaredHeight;
    /// The chordal axes around which it is inflated.
    Mask axes;
    /// Closed outlines, which do not cross: regions counter-clockwise, holes clockwise.
    std::vector<Loop> outlines;

    bool isEmpty() const { return outlines.empty(); }
    /// Squared height between the nodes; 0 outside.
    double squaredHeightAt(const GridPlace& place) const
    {
        const double inside = interpolate(distance, place);
        return inside > 0.0 ? std::max(interpolate(squaredHeight, place), inside * inside) : 0.0;
    }
};

/// Nodes that loops must leave free at each edge of the grid.
inline constexpr int kFieldMargin = 3;

/// Inflates what the loops enclose (see coverage()): the union of the balls that touch the outline from
/// inside around its chordal axes (TreeSketch §3.2: thinning, then inflation), and, in corners that the balls
/// on the axes do not fill, of the balls around the nodes there; so the silhouette is kept. A disc becomes a
/// ball, a strip a round bar. Parts thinner than a node vanish; the result is empty if nothing is left.
EnvelopeField inflate(std::span<const Loop> loops, int width, int height);

} // namespace espalier

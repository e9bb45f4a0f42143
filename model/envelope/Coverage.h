// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/envelope/Grid.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace espalier {

/// A closed polygon, its last point joined to its first, in units of a grid's nodes.
using Loop = std::vector<Eigen::Vector2d>;

/// How much of each node's square (±½ around it) the loops fill, 0...1: exact along x, in eight lines along
/// y. Each loop is filled by non-zero winding. A loop that lies wholly in another one is a hole of it, a loop
/// in a hole is an island, and so on; loops that overlap are united. Loops must lie in the grid.
Grid<float> coverage(std::span<const Loop> loops, int width, int height);

} // namespace espalier

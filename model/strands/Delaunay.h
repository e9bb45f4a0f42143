// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// The Delaunay triangulation of points in a plane: triangles as indices of points, counter-clockwise. Empty
/// if there are fewer than three points, or all lie on one line. Points are moved by up to @p jitter in
/// directions that their indices decide, so that those on lattices have a triangulation without ties; points
/// that coincide all but one are left out. O(n log n).
std::vector<std::array<std::uint32_t, 3>> delaunay(std::span<const Vec2> points, double jitter = 1e-4);

} // namespace espalier

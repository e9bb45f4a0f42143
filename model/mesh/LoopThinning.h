// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// Which points of a closed polygon are left so that the others lie within @p tolerance of it (Douglas and
/// Peucker), ascending; all of them if @p tolerance is 0. At least as many are left as a tube needs sides.
std::vector<std::uint32_t> thinLoop(std::span<const Vec2> points, float tolerance);

} // namespace espalier

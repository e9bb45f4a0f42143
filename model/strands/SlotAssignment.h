// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// Gives each of @p points one of as many @p slots, so that neighbours stay neighbours: both sets are divided
/// at their medians along the longer side of the slots, again and again. @p chosen[i] becomes the index of
/// the slot of point i. O(n log n). The result does not depend on where and how large the points are.
void assignSlots(std::span<const Vec2> points, std::span<const Vec2> slots, std::span<std::uint32_t> chosen);

} // namespace espalier

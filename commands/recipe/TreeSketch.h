// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/DepthInference.h"

#include <vector>

namespace espalier {

/// A tree as the user drew it, and how its depths are to be chosen.
struct TreeSketch {
    std::vector<std::vector<Vec2>> strokes; ///< m, right and up, in any order; as drawn, not smoothed
    DepthOptions depth{};                   ///< Those that readDepth() reads

    bool operator==(const TreeSketch&) const = default;
};

/// The greatest number of strokes of a sketch: the time to find their parents is proportional to its square.
inline constexpr std::size_t kMostSketchStrokes = 1000;

} // namespace espalier

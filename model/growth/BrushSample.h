// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

namespace espalier {

/// Where the brush was at a moment of a stroke. A stroke is a list of these by ascending time; between two,
/// brush and radius move evenly.
struct BrushSample {
    double time = 0.0;            ///< s since the stroke began
    Vec3 position = Vec3::Zero(); ///< m, in the tree's world
    float radius = 0.5F;          ///< m, 0 draws a single axis

    bool operator==(const BrushSample&) const = default;
};

/// The brush at @p time between two samples of ascending times.
inline BrushSample between(const BrushSample& a, const BrushSample& b, double time)
{
    const auto t = static_cast<float>((time - a.time) / (b.time - a.time));
    return {time, a.position + t * (b.position - a.position), a.radius + t * (b.radius - a.radius)};
}

} // namespace espalier

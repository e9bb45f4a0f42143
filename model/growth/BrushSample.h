// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

namespace espalier {

/// The brush at a moment of a stroke. A stroke is a list of samples by ascending time; between two samples,
/// position and radius change linearly.
struct BrushSample {
    double time = 0.0;            ///< s since the stroke began
    Vec3 position = Vec3::Zero(); ///< m, in the tree's world
    float radius = 0.5F;          ///< m, 0 draws a single axis

    bool operator==(const BrushSample&) const = default;
};

/// The brush at @p time, interpolated between two samples. Precondition: a.time < b.time.
inline BrushSample between(const BrushSample& a, const BrushSample& b, double time)
{
    const auto t = static_cast<float>((time - a.time) / (b.time - a.time));
    return {time, a.position + t * (b.position - a.position), a.radius + t * (b.radius - a.radius)};
}

} // namespace espalier

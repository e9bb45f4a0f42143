// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

namespace espalier {

/// The ellipse that gives the propensity of buds to grow around a level axis (TreeSketch §3.2, figure 10);
/// |offset| < vertical.
struct GravimorphismEllipse {
    double vertical = 1.0; ///< s_v
    double parallel = 1.0; ///< s_p
    double offset = 0.0;   ///< e_v

    bool isNeutral() const { return vertical == 1.0 && parallel == 1.0 && offset == 0.0; }
    bool operator==(const GravimorphismEllipse&) const = default;
};

/// Distance d from the axis to the ellipse in the direction χ (rad, 0 = top, π = bottom). If the axis is
/// outside the ellipse: the length of the ray inside it, which is continuous, and 0 where the ray misses the
/// ellipse.
double ellipseDistance(const GravimorphismEllipse& ellipse, double chi);

/// Propensity b = cos²τ + d sin²τ of a bud to grow (eq. 1). @p heading and @p bud are unit vectors along the
/// parent axis and the bud. 1 for a vertical axis, and for a bud that points along its axis.
double gravimorphicBias(const GravimorphismEllipse& ellipse, const Vec3& heading, const Vec3& bud);

} // namespace espalier

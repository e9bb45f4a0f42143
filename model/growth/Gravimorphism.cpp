// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Gravimorphism.h"

#include <algorithm>
#include <cmath>

namespace espalier {

double ellipseDistance(const GravimorphismEllipse& ellipse, double chi)
{
    const double sv2 = ellipse.vertical * ellipse.vertical;
    const double sp2 = ellipse.parallel * ellipse.parallel;
    const double cosChi = std::cos(chi);
    const double sinChi = std::sin(chi);
    // Intersections t of the ray (t cosχ, t sinχ) with the ellipse: A t² − 2 B t + C = 0.
    const double a = cosChi * cosChi / sv2 + sinChi * sinChi / sp2;
    const double b = ellipse.offset * cosChi / sv2;
    const double discriminant = a - ellipse.offset * ellipse.offset * sinChi * sinChi / (sv2 * sp2);
    if (discriminant < 0.0)
        return 0.0;
    const double root = std::sqrt(discriminant);
    const double nearer = (b - root) / a;
    const double farther = (b + root) / a;
    return std::max(0.0, farther - std::max(0.0, nearer));
}

double gravimorphicBias(const GravimorphismEllipse& ellipse, const Vec3& heading, const Vec3& bud)
{
    const Vec3 level = heading.cross(up());
    const double sinTau = level.norm();
    if (sinTau < 1e-6)
        return 1.0;
    const Vec3 parallel = level / static_cast<float>(sinTau); // P
    const Vec3 vertical = parallel.cross(heading);            // V
    const double alongVertical = bud.dot(vertical);
    const double alongParallel = bud.dot(parallel);
    if (std::hypot(alongVertical, alongParallel) < 1e-6)
        return 1.0;
    const double distance = ellipseDistance(ellipse, std::atan2(alongParallel, alongVertical));
    const double sin2 = sinTau * sinTau;
    return 1.0 - sin2 + distance * sin2;
}

} // namespace espalier

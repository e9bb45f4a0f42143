// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Tropism.h"

#include <cmath>

namespace espalier {

Vec3 tropismVector(const Vec3& heading, double theta, const Vec3& levelDirection)
{
    Vec3 level = heading - heading.dot(up()) * up();
    const float norm = level.norm();
    level = norm < 1e-4F ? levelDirection : Vec3(level / norm);
    return static_cast<float>(std::cos(theta)) * up() + static_cast<float>(std::sin(theta)) * level;
}

Vec3 growthDirection(const DirectionWeights& weights, const Vec3& heading, const Vec3& tropism,
                     const Vec3& space)
{
    const Vec3 sum = static_cast<float>(weights.axis) * heading +
                     static_cast<float>(weights.tropism) * tropism +
                     static_cast<float>(weights.space) * space;
    const float norm = sum.norm();
    return norm < 1e-6F ? heading : Vec3(sum / norm);
}

} // namespace espalier

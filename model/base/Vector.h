// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <numbers>

namespace espalier {

/// Positions and directions: metres, Y up, right-handed.
using Vec2 = Eigen::Vector2f;
using Vec3 = Eigen::Vector3f;
/// Unaligned, so that it packs into columns of 16 bytes a row.
using Rotation = Eigen::Quaternion<float, Eigen::DontAlign>;
using Box3 = Eigen::AlignedBox3f;

inline Vec3 up()
{
    return Vec3::UnitY();
}

constexpr double radians(double degrees)
{
    return degrees * std::numbers::pi / 180.0;
}

constexpr double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

/// A unit vector perpendicular to the unit vector @p direction; continuous but for one half-line.
inline Vec3 anyPerpendicular(const Vec3& direction)
{
    const Vec3 axis = std::abs(direction.x()) < 0.9F ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ());
    return (axis - axis.dot(direction) * direction).normalized();
}

} // namespace espalier

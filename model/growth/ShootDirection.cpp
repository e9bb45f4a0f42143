// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/ShootDirection.h"

#include "model/base/Random.h"

#include <array>
#include <cmath>

namespace espalier {

namespace {

/// Distance at which the light is felt, in voxel edges.
constexpr float kSightOfLight = 2.0F;

/// The zenith and two rings of the upper half ball.
std::array<Vec3, 13> upperDirections()
{
    std::array<Vec3, 13> directions;
    std::size_t count = 0;
    directions[count++] = Vec3::UnitY();
    const auto ring = [&](int points, double elevation) {
        for (int i = 0; i < points; ++i) {
            const double azimuth = 2.0 * std::numbers::pi * (i + 0.5) / points;
            directions[count++] = Vec3(static_cast<float>(std::cos(elevation) * std::cos(azimuth)),
                                       static_cast<float>(std::sin(elevation)),
                                       static_cast<float>(std::cos(elevation) * std::sin(azimuth)));
        }
    };
    ring(4, radians(60));
    ring(8, radians(20));
    return directions;
}

double phyllotaxisOf(const TreeParameters& parameters, int laterals)
{
    if (parameters.growth.model != GrowthModelKind::Vigour)
        return parameters.growth.phyllotaxis;
    return laterals == 1 ? radians(137.5) : std::numbers::pi / laterals;
}

} // namespace

Vec3 turnedToward(const Vec3& heading, const Vec3& target, double share)
{
    const Vec3 axis = heading.cross(target);
    const float sine = axis.norm();
    if (sine < 1e-4F)
        return heading;
    const float angle = std::atan2(sine, heading.dot(target));
    return (Eigen::AngleAxisf(static_cast<float>(share) * angle, axis / sine) * heading).normalized();
}

Vec3 lightDirection(const VoxelSpace& space, const Vec3& position)
{
    static const std::array<Vec3, 13> kDirections = upperDirections();
    Vec3 sum = Vec3::Zero();
    for (const Vec3& direction : kDirections)
        sum += space.light(space.cellAt(position + kSightOfLight * space.edge() * direction)) * direction;
    return sum.norm() > 1e-4F ? Vec3(sum.normalized()) : Vec3(Vec3::UnitY());
}

Vec3 shootDirection(const GrowingTree& growing, const VoxelSpace& space, const VigourParameters& p,
                    const BudRef& bud, int order)
{
    const auto [node, slot] = bud;
    const Vec3 up = Vec3::UnitY();
    Vec3 heading = growing.budDirection(node, slot);
    if (slot == kTerminalSlot) {
        Random random(growing.key(node), static_cast<std::uint32_t>(slot), Purpose::Direction);
        const auto turn = static_cast<float>(p.apicalSpread * random.normal());
        const auto azimuth = static_cast<float>(random.uniform(0.0, std::numbers::pi));
        const Vec3 side(std::cos(azimuth), 0.0F, std::sin(azimuth));
        heading = std::cos(turn) * heading + std::sin(turn) * (growing.rotation(node) * side);
    } else if (p.horizontalTropism > 0.0) {
        const Vec3 level(heading.x(), 0.0F, heading.z());
        if (level.norm() > 1e-3F)
            heading = turnedToward(heading, level.normalized(), p.horizontalTropism);
    }
    if (p.gravitropism >= 0.0 || order == 0)
        heading = turnedToward(heading, up, std::abs(p.gravitropism));
    else
        heading = turnedToward(heading, -up, -p.gravitropism);
    if (p.phototropism > 0.0)
        heading =
            turnedToward(heading, lightDirection(space, growing.stretchedPosition(node)), p.phototropism);
    return heading.normalized();
}

double shootRoll(const GrowingTree& growing, const VigourParameters& p, const BudRef& bud)
{
    Random random(growing.key(bud.node), static_cast<std::uint32_t>(bud.slot), Purpose::Phyllotaxis);
    if (bud.slot != kTerminalSlot)
        return random.uniform(0.0, 2.0 * std::numbers::pi);
    return phyllotaxisOf(growing.tree().parameters(), p.lateralBuds) + p.rollSpread * random.normal();
}

} // namespace espalier

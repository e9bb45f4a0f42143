// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Buds.h"

#include "model/base/Random.h"

namespace espalier {

namespace {

/// Standard deviations at full irregularity.
constexpr double kBranchingSpread = radians(18);
constexpr double kAzimuthSpread = radians(25);

} // namespace

Vec3 budDirection(std::uint64_t seed, InternodeId id, int slot, const Rotation& rotation, const GrowthParameters& grown)
{
    if (slot == kTerminalSlot)
        return rotation * Vec3(Vec3::UnitY());
    Random random(seed, static_cast<std::uint32_t>(slot), id, Purpose::BranchingAngle);
    const double angle = std::clamp(grown.branchingAngle + grown.irregularity * kBranchingSpread * random.normal(), 0.0,
                                    radians(170));
    const double azimuth = 2.0 * std::numbers::pi * slot / grown.lateralsPerNode +
                           grown.irregularity * kAzimuthSpread * random.normal();
    const double outward = std::sin(angle);
    return rotation * Vec3(static_cast<float>(outward * std::cos(azimuth)), static_cast<float>(std::cos(angle)),
                           static_cast<float>(outward * std::sin(azimuth)));
}

BudMask newBuds(const GrowthParameters& parameters)
{
    return static_cast<BudMask>(kTerminalBud | ((1U << parameters.lateralsPerNode) - 1U));
}

} // namespace espalier

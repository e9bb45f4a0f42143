// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Buds.h"

#include "model/base/Random.h"

namespace espalier {

namespace {

/// Standard deviations at full irregularity.
constexpr double kBranchingSpread = radians(18);
constexpr double kAzimuthSpread = radians(25);
constexpr double kWidestBranching = radians(170);

/// Sine and cosine of an angle of at most π/2 either way, to 3e-6: Taylor's series, a tenth of the library's
/// cost.
double smallSine(double x)
{
    const double y = x * x;
    return x * (1.0 - y / 6.0 * (1.0 - y / 20.0 * (1.0 - y / 42.0 * (1.0 - y / 72.0))));
}

double smallCosine(double x)
{
    const double y = x * x;
    return 1.0 - y / 2.0 * (1.0 - y / 12.0 * (1.0 - y / 30.0 * (1.0 - y / 56.0 * (1.0 - y / 90.0))));
}

} // namespace

BudAngles::BudAngles(const GrowthParameters& grown)
    : m_branchingAngle(grown.branchingAngle),
      m_branching{std::cos(grown.branchingAngle), std::sin(grown.branchingAngle)},
      m_irregularity(grown.irregularity),
      m_lateralsPerNode(grown.lateralsPerNode)
{
    for (int slot = 0; slot < kMaxLaterals; ++slot) {
        const double azimuth = 2.0 * std::numbers::pi * slot / grown.lateralsPerNode;
        m_azimuths[static_cast<std::size_t>(slot)] = {std::cos(azimuth), std::sin(azimuth)};
    }
}

Vec3 BudAngles::direction(std::uint64_t seed, InternodeId id, int slot) const
{
    if (slot == kTerminalSlot)
        return Vec3::UnitY();
    Random random(seed, static_cast<std::uint32_t>(slot), id, Purpose::BranchingAngle);
    const double tilt = std::clamp(m_irregularity * kBranchingSpread * random.normal(), -m_branchingAngle,
                                   std::max(0.0, kWidestBranching - m_branchingAngle));
    const double turn = m_irregularity * kAzimuthSpread * random.normal();
    const auto rotated = [](const Turn& base, double by) {
        const double cosine = smallCosine(by);
        const double sine = smallSine(by);
        return Turn{base.cosine * cosine - base.sine * sine, base.sine * cosine + base.cosine * sine};
    };
    const Turn branching = rotated(m_branching, tilt);
    const Turn azimuth = rotated(m_azimuths[static_cast<std::size_t>(slot)], turn);
    return {static_cast<float>(branching.sine * azimuth.cosine), static_cast<float>(branching.cosine),
            static_cast<float>(branching.sine * azimuth.sine)};
}

Vec3 budDirection(std::uint64_t seed, InternodeId id, int slot, const Rotation& rotation,
                  const GrowthParameters& grown)
{
    return rotation * BudAngles(grown).direction(seed, id, slot);
}

BudMask newBuds(const GrowthParameters& parameters)
{
    return static_cast<BudMask>(kTerminalBud | ((1U << parameters.lateralsPerNode) - 1U));
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Buds.h"

#include "model/base/Random.h"

namespace espalier {

namespace {

/// Standard deviations, rad, at full irregularity.
constexpr double kBranchingSpread = radians(18);
constexpr double kAzimuthSpread = radians(25);
constexpr double kWidestBranching = radians(170);
/// The vigour model has no parameter for this.
constexpr double kVigourIrregularity = 0.4;

/// Sine and cosine of an angle within ±π/2, rad, with an error below 3e-6. Taylor series take a tenth of the
/// time of the library's functions.
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

struct Direction {
    double cosine;
    double sine;

    explicit Direction(double angle) : cosine(std::cos(angle)), sine(std::sin(angle)) {}
    Direction(double c, double s) : cosine(c), sine(s) {}

    Direction turnedBy(double angle) const
    {
        const double c = smallCosine(angle);
        const double s = smallSine(angle);
        return {cosine * c - sine * s, sine * c + cosine * s};
    }
};

double azimuthOf(const BudForm& form, int slot)
{
    constexpr double kGoldenAngle = radians(137.507764);
    if (budKind(slot) == BudKind::Adventitious)
        return kGoldenAngle * (slot - kFirstAdventitiousSlot);
    return 2.0 * std::numbers::pi * slot / form.laterals;
}

/// Unit direction of a lateral bud in the frame of its internode.
Vec3 scattered(InternodeKey key, int slot, double branchingAngle, const Direction& branching,
               const Direction& azimuth, double irregularity)
{
    Random random(key, static_cast<std::uint32_t>(slot), Purpose::BranchingAngle);
    const double tilt = std::clamp(irregularity * kBranchingSpread * random.normal(), -branchingAngle,
                                   std::max(0.0, kWidestBranching - branchingAngle));
    const double turn = irregularity * kAzimuthSpread * random.normal();
    const Direction away = branching.turnedBy(tilt);
    const Direction around = azimuth.turnedBy(turn);
    return {static_cast<float>(away.sine * around.cosine), static_cast<float>(away.cosine),
            static_cast<float>(away.sine * around.sine)};
}

} // namespace

BudForm::BudForm(const TreeParameters& parameters) : BudForm(parameters.growth)
{
    if (parameters.growth.model != GrowthModelKind::Vigour)
        return;
    branchingAngle = parameters.vigour.branchingAngle;
    irregularity = kVigourIrregularity;
    laterals = parameters.vigour.lateralBuds;
}

BudAngles::BudAngles(const BudForm& form)
    : m_form(form), m_branching{std::cos(form.branchingAngle), std::sin(form.branchingAngle)}
{
    for (int slot = 0; slot < kBudSlots; ++slot) {
        const double azimuth = azimuthOf(form, slot);
        m_azimuths[static_cast<std::size_t>(slot)] = {std::cos(azimuth), std::sin(azimuth)};
    }
}

Vec3 BudAngles::direction(InternodeKey key, int slot) const
{
    if (slot == kTerminalSlot)
        return Vec3::UnitY();
    const Turn& azimuth = m_azimuths[static_cast<std::size_t>(slot)];
    return scattered(key, slot, m_form.branchingAngle, {m_branching.cosine, m_branching.sine},
                     {azimuth.cosine, azimuth.sine}, m_form.irregularity);
}

Vec3 budDirection(InternodeKey key, int slot, const Rotation& rotation, const BudForm& form)
{
    if (slot == kTerminalSlot)
        return rotation * Vec3(Vec3::UnitY());
    return rotation * scattered(key, slot, form.branchingAngle, Direction(form.branchingAngle),
                                Direction(azimuthOf(form, slot)), form.irregularity);
}

BudMask newBuds(const BudForm& form)
{
    return static_cast<BudMask>(kTerminalBud | ((1U << form.laterals) - 1U));
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Widths.h"

#include "model/shape/WidthRegions.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr double kSmallestExponent = 0.5;
constexpr double kLargestExponent = 10.0;
constexpr std::uint32_t kTableSize = 1024;

/// p of d = d_e · tips^p: 1 / n, or where n is beyond its limits, the power that still leads to the base's
/// diameter.
double widthPower(const WidthParameters& parameters, std::uint32_t tips, double exponent)
{
    if (tips < 2 || parameters.baseDiameter <= 0.0 || parameters.tipDiameter <= 0.0)
        return 1.0 / exponent;
    return std::log(parameters.baseDiameter / parameters.tipDiameter) / std::log(static_cast<double>(tips));
}

} // namespace

double widthExponent(std::uint32_t tips, double tipDiameter, double baseDiameter, double fallback)
{
    if (tips < 2 || baseDiameter <= tipDiameter)
        return fallback;
    const double exponent =
        std::log(static_cast<double>(tips)) / (std::log(baseDiameter) - std::log(tipDiameter));
    return std::clamp(exponent, kSmallestExponent, kLargestExponent);
}

Widths::Widths(const WidthParameters& parameters, std::uint32_t trunkTips)
    : m_exponent(
          widthExponent(trunkTips, parameters.tipDiameter, parameters.baseDiameter, parameters.exponent)),
      m_power(widthPower(parameters, trunkTips, m_exponent)),
      m_tipRadius(parameters.tipDiameter / 2.0)
{
    m_table.reserve(kTableSize);
    for (std::uint32_t tips = 0; tips < std::min(kTableSize, trunkTips + 1); ++tips)
        m_table.push_back(tips == 0 ? 0.0F : static_cast<float>(m_tipRadius * std::pow(tips, m_power)));
}

Widths::Widths(const Tree& tree, const TreeIndex& index, std::span<const WidthConstraint> constraints)
    : Widths(tree.parameters().widths, index.greatestTipCount())
{
    std::vector<WidthConstraint> living;
    for (const WidthConstraint& constraint : constraints) {
        if (constraint.id < tree.size() && tree.isAlive(constraint.id))
            living.push_back(constraint);
    }
    const bool tapersByLength = index.greatestTipCount() == 1 && tree.parameters().widths.baseDiameter > 0.0;
    if (!living.empty() || tapersByLength)
        m_radii = constrainedRadii(tree, index, living, m_power);
}

float Widths::radiusOfTips(std::uint32_t tips) const
{
    if (tips < m_table.size())
        return m_table[tips];
    return static_cast<float>(m_tipRadius * std::pow(tips, m_power));
}

} // namespace espalier

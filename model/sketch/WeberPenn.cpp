// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/WeberPenn.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace espalier {

double shapeRatio(CrownShape shape, double ratio)
{
    const double x = std::clamp(ratio, 0.0, 1.0);
    switch (shape) {
    case CrownShape::Conical:
        return 0.2 + 0.8 * x;
    case CrownShape::Spherical:
        return 0.2 + 0.8 * std::sin(std::numbers::pi * x);
    case CrownShape::Hemispherical:
        return 0.2 + 0.8 * std::sin(0.5 * std::numbers::pi * x);
    case CrownShape::Cylindrical:
        return 1.0;
    case CrownShape::TaperedCylindrical:
        return 0.5 + 0.5 * x;
    case CrownShape::Flame:
        return x <= 0.7 ? x / 0.7 : (1.0 - x) / 0.3;
    case CrownShape::InverseConical:
        return 1.0 - 0.8 * x;
    case CrownShape::TendFlame:
        return 0.5 + 0.5 * (x <= 0.7 ? x / 0.7 : (1.0 - x) / 0.3);
    }
    return 1.0;
}

double childLength(double share, double parentLength, double offset)
{
    return share * (parentLength - 0.6 * offset);
}

std::vector<double> drawnLengthShares(std::span<const BranchLength> branches)
{
    std::vector<double> shares;
    for (const BranchLength& branch : branches) {
        const auto order = static_cast<std::size_t>(branch.order);
        if (shares.size() <= order)
            shares.resize(order + 1, 0.0);
        const double whole = childLength(1.0, branch.parentLength, branch.offset);
        if (branch.order > 0 && whole > 0.0)
            shares[order] = std::max(shares[order], branch.length / whole);
    }
    return shares;
}

} // namespace espalier

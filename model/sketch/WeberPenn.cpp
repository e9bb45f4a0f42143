// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/WeberPenn.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace espalier {

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

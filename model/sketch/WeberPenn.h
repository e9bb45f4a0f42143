// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace espalier {

/// A branch as a straight segment from its base to its tip.
struct BranchLength {
    int order = 0;             ///< 0: the trunk
    double length = 0.0;       ///< m
    double parentLength = 0.0; ///< m
    double offset = 0.0;       ///< m, from the parent's base to this one's; 0...parentLength
};

/// The length of a branch of second or higher order by Weber & Penn: @p share (their length of a child at the
/// parent's base as a share of the parent's) times (parent's length - 0.6 offset), m.
double childLength(double share, double parentLength, double offset);

/// For each order the least share with which childLength() admits all these branches; the result's index is
/// the order, and its size the greatest order + 1. Zero where an order has no branches whose parent has a
/// length. Weber & Penn give the share for each species; for a drawing it is uncertain, and this choice
/// admits whatever was drawn.
std::vector<double> drawnLengthShares(std::span<const BranchLength> branches);

} // namespace espalier

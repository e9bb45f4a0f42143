// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

namespace espalier {

/// World direction, of unit length, of the bud @p slot at a node: along the internode for the terminal bud, else at the branching angle
/// ψ and evenly around the node, from its frame's +X on (TreeSketch figure 8A), with the irregularity of the parameters that the
/// internode was grown with.
/// @param rotation world frame of the internode @p id
/// @param grown    parameters that it was grown with
Vec3 budDirection(std::uint64_t seed, InternodeId id, int slot, const Rotation& rotation, const GrowthParameters& grown);

/// The buds that a new internode bears.
BudMask newBuds(const GrowthParameters& parameters);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <cstdint>

namespace espalier {

/// The greatest angle between the upward direction and a branch that multiplied() adds, rad (Okabe
/// 2005, 4.3).
inline constexpr double kMostFromUp = radians(120);

/// One more branch on a branch, made by the example of those that it carries (branch multiplication, Okabe
/// 2005, 3.4 and 4.3). @p id: any internode of the branch that gets it. @p seed: of the random choices.
///
/// The new branch begins in the middle of the widest gap between two neighbours along the branch. Where one
/// branch is alone, or all begin at the same place, it is the middle of the longer of the two ends (the paper
/// does not say). Length and down angle (between the directions of the branch and of the first internode) are
/// the means of the neighbours'. It is a scaled copy of one of the branches there, chosen at random, with all
/// that it carries.
///
/// The rotation angle is the one that is farthest from those of the other branches, in the turtle's frames
/// (BranchAxis), among those at which the direction is at most kMostFromUp from the upward one; of equal
/// ones, the one that is farthest from the neighbours along the branch (the paper does not say). Where there
/// is none, on a branch that hangs down, the down angle grows until there is one.
///
/// Fails (Kind::Input) if the internode is not alive, if nothing on the branch can be imitated, or as
/// BranchCopies::finish() does.
Result<TreeDelta> multiplied(const Tree& tree, const TreeIndex& index, InternodeId id, std::uint64_t seed);

} // namespace espalier

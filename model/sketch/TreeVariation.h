// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <cstdint>

namespace espalier {

/// The trees of a document with slightly different angles and lengths, so that copies of one tree can stand
/// in a forest; the same branches and internodes stay. @p seed: of the random numbers, which follow from it
/// and the internodes' keys alone. @p amount: 0 (nothing changes)...1.
///
/// With an amount of 1, standard deviations are: 25° of a branch's rotation around its parent, 10° of its
/// down angle, 4° of the turn at each node along an axis, 20 % of a branch's length and 10 % of an
/// internode's. A trunk turns around the vertical by up to 180° to either side. All deviations are
/// proportional to the amount (those of lengths to its exponential), and none is more than 3.5 times as
/// large.
///
/// Fails (Kind::Input) if an internode would become longer than kGreatestLength or lie farther away than
/// kFarthestNode.
Result<TreeDelta> varied(const Tree& tree, const TreeIndex& index, std::uint64_t seed, double amount);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandNode.h"
#include "model/tree/Parameters.h"

namespace espalier {

/// Moves forks up to where their branches are further apart than α (Strands 2024, figure 8): as far as two
/// branches of a fork diverge by less, what passes their nodes is one bundle. Its nodes lie between those of
/// the two, weighted by their thickness. Branches that leave much thicker wood, or turn aside, part at once.
///
/// Precondition: parents come before children, and children are not linked yet. Postcondition: the same.
void joinForks(StrandSkeleton& skeleton, const WoodParameters& wood);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

namespace espalier {

/// Takes the youngest internodes of the branch that @p id carries away: those that were born last, all in the
/// same step. The buds that they grew from are active again. @p id itself stays. The delta is empty if @p id
/// is dead or carries nothing.
TreeDelta reduceBranch(const Tree& tree, const TreeIndex& index, InternodeId id);

} // namespace espalier

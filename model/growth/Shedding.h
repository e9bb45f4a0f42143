// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BorchertHonda.h"
#include "model/growth/GrowingTree.h"

namespace espalier {

/// Sheds branches that do not pay (TreeSketch §3.2): those whose vigour per internode, relative to the whole
/// tree's, is below Th. Asked are the branches on which the new growth of @p tree casts its shadow, parents
/// before their children; spared are the trunk, branches younger than a few steps, and those that carry a
/// node of @p growingAt. With vigour as before the step.
void shedBranches(GrowingTree& tree, const GrowthIndex& growth, VigourFlow& flow,
                  const std::vector<InternodeId>& growingAt, GrowthWorkspace& workspace);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BorchertHonda.h"
#include "model/growth/GrowingTree.h"

namespace espalier {

/// Sheds branches with too little vigour (TreeSketch §3.2): those whose vigour per internode, relative to
/// that of the whole tree, is below Th. Checks the branches on which the new growth of @p tree casts its
/// shadow, parents before children. The trunk, branches younger than a few steps, branches that a person
/// placed, and branches that carry a node of @p growingAt are not shed for themselves. Vigour is that before
/// the step.
void shedBranches(GrowingTree& tree, const GrowthIndex& growth, VigourFlow& flow,
                  const std::vector<InternodeId>& growingAt, GrowthWorkspace& workspace);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BranchStroke.h"
#include "model/document/TreeDocument.h"

namespace espalier {

/// Lets a branch, or the trunk, grow as it was drawn (Okabe 2005, 3.2): one undo step. A line whose last
/// point is the base is turned round. Returns the first new internode, or 0 for the trunk. Fails
/// (Kind::Input), and changes nothing, as growDrawnBranch() does.
Result<InternodeId> sketchBranch(TreeDocument& document, BranchStroke stroke);

} // namespace espalier

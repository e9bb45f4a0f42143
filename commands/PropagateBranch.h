// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/sketch/BranchPropagation.h"

namespace espalier {

/// Copies what a branch carries to others (propagated()), as one undo step. Changes nothing if propagated()
/// fails, and returns its error.
Result<void> propagateBranch(TreeDocument& document, const Propagation& propagation);

} // namespace espalier

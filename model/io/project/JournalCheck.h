// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/Tree.h"

namespace espalier {

/// Whether @p journal can be the history of @p tree: whether reverting all of it, last to first, and applying
/// it again is safe and leads back to the same tree. Reverts a copy of the tree, in a time that is linear in
/// the tree and the journal. Precondition: treeFault() finds no fault in the tree.
Result<void> checkJournal(const Tree& tree, const Journal& journal);

/// The error of a journal whose delta number @p place (from 0) is empty. Edit keeps no empty deltas.
Error emptyDelta(std::size_t place);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/Tree.h"

namespace espalier {

/// Whether @p journal can be the history of @p tree: whether reverting all of it, last to first, and applying
/// it again is safe and leads back to the same tree. Simulates both on plain columns, in a time that is
/// linear in the tree and the journal. Precondition: the tree came from Tree::fromColumns.
Result<void> checkJournal(const Tree& tree, const Journal& journal);

} // namespace espalier

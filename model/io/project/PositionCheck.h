// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/Tree.h"

namespace espalier {

/// Fails if a node, living or dead, lies further than kFarthestNode from the world's origin along an axis, in
/// @p tree or at an earlier moment of @p journal. So a tree within the limits can be edited and saved at each
/// moment that the user travels to.
///
/// A tree in which no path from a root is longer than kFarthestNode, at its greatest lengths, takes one pass
/// over its rows and the changes of lengths. In a longer tree, the rows that a delta moves are placed again
/// for each delta; this also fails if the deltas move more than projectLimits::kMovedRows rows. Precondition:
/// checkJournal() has accepted the journal.
Result<void> checkPositions(const Tree& tree, const Journal& journal);

} // namespace espalier

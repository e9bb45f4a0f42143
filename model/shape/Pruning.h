// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <span>

namespace espalier {

/// Returns where the branch of @p id is cut (TreeSketch §3.3): the internode that begins at the branching
/// point below it, or just above a width constraint below it, so that the stub stays. Everything from there
/// on is removed. kNoInternode if there is nothing to cut: @p id is dead, or a root.
InternodeId cutBelow(const Tree& tree, const TreeIndex& index, InternodeId id);

/// Removes the internodes @p cuts with all that they carry. Dead internodes, roots, and internodes above
/// another cut are ignored. The delta is empty if nothing is removed.
TreeDelta prune(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> cuts);

/// The living internodes that prune() would take away, by ascending id.
std::vector<InternodeId> falling(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> cuts);

} // namespace espalier

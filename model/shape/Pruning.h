// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <span>

namespace espalier {

/// Where the branch that @p id belongs to is cut (TreeSketch §3.3): the internode that begins at the
/// branching point below it, or just above a width constraint below it, so that the stub stays. Everything
/// from there on goes. 0, the seedling, if there is nothing to cut.
InternodeId cutBelow(const Tree& tree, const TreeIndex& index, InternodeId id);

/// Takes the internodes @p cuts away with all that they carry; those that are dead, the seedling, and what
/// lies above another cut count for nothing. The delta is empty if nothing falls.
TreeDelta prune(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> cuts);

/// The living internodes that prune() would take away, by ascending id.
std::vector<InternodeId> falling(const Tree& tree, const TreeIndex& index, std::span<const InternodeId> cuts);

} // namespace espalier

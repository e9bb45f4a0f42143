// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <span>

namespace espalier {

/// Removes the internodes @p cuts with all that they carry, as one undo step (TreeSketch §3.3); the widths of
/// the rest become as if the removed branches had never existed. Does nothing if no internode is removed.
void pruneBranches(TreeDocument& document, std::span<const InternodeId> cuts);

} // namespace espalier

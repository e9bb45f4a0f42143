// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <span>

namespace espalier {

/// Takes the internodes @p cuts away with all that they carry, as one undo step (TreeSketch §3.3); the widths
/// of what is left become as if they had never been. Does nothing if nothing falls.
void pruneBranches(TreeDocument& document, std::span<const InternodeId> cuts);

} // namespace espalier

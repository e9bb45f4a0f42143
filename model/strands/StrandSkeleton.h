// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/shape/Widths.h"
#include "model/strands/StrandNode.h"

#include <vector>

namespace espalier {

/// For each node of @p skeleton the one of @p other at the same place of the same internode, or kNoNode.
std::vector<std::uint32_t> matchingNodes(const StrandSkeleton& skeleton, const StrandSkeleton& other);

StrandSkeleton strandSkeleton(const Tree& tree, const TreeIndex& index, const Widths& widths);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/shape/Widths.h"
#include "model/strands/StrandNode.h"

namespace espalier {

StrandSkeleton strandSkeleton(const Tree& tree, const TreeIndex& index, const Widths& widths);

} // namespace espalier

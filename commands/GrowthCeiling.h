// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

namespace espalier {

/// The number of internodes, the dead included, up to which growth that runs by itself lets @p tree grow: as
/// many as a project file can hold, and as the machine has memory for.
std::uint32_t growthCeiling(const Tree& tree);

} // namespace espalier

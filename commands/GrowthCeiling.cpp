// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowthCeiling.h"

#include "model/base/Memory.h"
#include "model/io/project/ProjectLimits.h"

#include <algorithm>

namespace espalier {

namespace {

/// What an internode takes in all: in the tree, its indices, its history and the meshes of the window.
constexpr std::uint64_t kBytes = 1500;
/// The share of the available memory that growth may take. Saving and exports need the rest.
constexpr double kShare = 0.6;

} // namespace

std::uint32_t growthCeiling(const Tree& tree)
{
    const double room = kShare * static_cast<double>(availableMemory()) / static_cast<double>(kBytes);
    return static_cast<std::uint32_t>(
        std::min(static_cast<double>(projectLimits::kInternodes), static_cast<double>(tree.size()) + room));
}

} // namespace espalier

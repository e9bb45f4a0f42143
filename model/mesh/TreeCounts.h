// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <cstdint>

namespace espalier {

/// Sizes of the living tree.
struct TreeCounts {
    std::uint64_t internodes = 0;
    std::uint64_t buds = 0;
    std::uint64_t leaves = 0;       ///< By rule and placed
    std::uint64_t leavesPlaced = 0; ///< Those of them that the user has placed
    std::uint64_t axes = 0;
    Step steps = 0; ///< Growth steps
};

TreeCounts countTree(const Tree& tree, const TreeIndex& index);

/// The box around all living nodes, the placed leaves, the bases of the trunks and the origin, m.
Box3 treeBounds(const Tree& tree, const TreeIndex& index);

} // namespace espalier

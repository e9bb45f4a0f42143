// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/DrawnBranch.h"
#include "model/tree/LassoStroke.h"

#include <optional>
#include <vector>

namespace espalier {

/// A stroke that becomes a branch.
struct BranchStroke {
    LassoStroke stroke; ///< The plane, and the line in it: smooth, two points or more
    std::optional<BranchPlace>
        base; ///< None: the wood that an end of the line is nearest to, seen at right angles
    std::vector<float> radii{}; ///< m, at even distances from base to tip; empty: what it carries decides
    std::optional<InternodeId>
        replaces{}; ///< An axis that the stroke takes the place of, with all that it carries
    bool isMirrored =
        false; ///< Whether its mirror image, to the other side of the trunk's foot, is drawn as well
};

} // namespace espalier

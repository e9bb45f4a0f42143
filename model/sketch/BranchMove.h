// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/sketch/BranchPlace.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

namespace espalier {

/// Where a branch goes.
struct BranchMove {
    static constexpr double kLeastScale = 0.01;
    static constexpr double kMostScale = 100.0;

    InternodeId branch = 0;                   ///< Any internode of its axis
    BranchPlace place;                        ///< Of its base
    Rotation rotation = Rotation::Identity(); ///< Of its first internode, in the frame of the internode there
    double scale = 1.0;                       ///< Of lengths and diameters, kLeastScale...kMostScale

    bool operator==(const BranchMove&) const = default;
};

/// Moves a branch with all that it carries, its placed leaves included, to another place on the wood, and
/// turns and scales it. In time it begins anew there: the branch dies where it was, and its copy
/// (BranchCopies) is born.
///
/// Fails (Kind::Input) if the branch is not alive or is a trunk, if the place is not alive or is on the
/// branch itself, if the scale is out of range, or as BranchCopies::finish() does.
Result<TreeDelta> moved(const Tree& tree, const TreeIndex& index, const BranchMove& move);

/// The first internode of a branch that moved() has just moved, in the tree after the delta.
inline InternodeId movedBranch(const TreeDelta& delta)
{
    return delta.born.first;
}

} // namespace espalier

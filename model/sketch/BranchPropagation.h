// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <vector>

namespace espalier {

/// What is copied from one branch to others, and how.
struct Propagation {
    /// The branches that get the copies. The trunks, the reference and what it carries are among them only if
    /// they are listed; the reference never is (the paper does not say).
    enum class Targets {
        All,
        SameOrder, ///< Those with as many branchings below them as the reference
        Listed,    ///< `axes`
    };

    static constexpr std::size_t kMostListed = 10'000; ///< Axes

    InternodeId reference = 0; ///< Any internode of the branch that serves as the example
    Targets targets = Targets::All;
    std::vector<InternodeId> axes; ///< For Listed: up to kMostListed internodes; those not alive are ignored
    bool scaling = true;   ///< Places and sizes follow the length of the target; otherwise tips are aligned
    bool replaces = false; ///< Branches and leaves that the targets carry are removed first

    bool operator==(const Propagation&) const = default;
};

/// Copies the branches and placed leaves that a branch carries, the reference, to other branches (branch
/// propagation, Okabe 2005, 3.6 and figure 11).
///
/// With scaling, a copy has the same share of the target's length below it as the original has on the
/// reference, and its size is multiplied by the ratio of the two lengths. Without, sizes and distances from
/// the tip stay, and what would lie below the target's base is left out. Directions are those of the original
/// in the turtle's frame (BranchAxis).
///
/// If targets lose what they carry, a target that stands on another target is lost with it; a branch that
/// carries the reference stays.
///
/// Fails (Kind::Input) if the reference is not alive or carries nothing, if there is no target or there are
/// too many, if nothing changes because all targets are too short, or as BranchCopies::finish() does.
Result<TreeDelta> propagated(const Tree& tree, const TreeIndex& index, const Propagation& propagation);

} // namespace espalier

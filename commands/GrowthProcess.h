// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthModel.h"

#include <span>
#include <vector>

namespace espalier {

/// What makes a tree grow step by step without a hand. It keeps what one step hands on to the next, but not
/// the tree: on equal trees the same steps are the same, so they may be worked out on a copy (GrowthReplica).
class GrowthProcess {
public:
    virtual ~GrowthProcess() = default;
    /// The next step of a tree to which the steps before were applied; empty if growth has come to its end.
    virtual TreeDelta step(const Tree& tree, const TreeIndex& index, const GrowthModel& model) = 0;
    /// World positions of the living markers of free space; none if they last no longer than a step.
    virtual std::span<const Vec3> markers() const { return {}; }
};

/// A step, and the markers that it has left.
struct GrownStep {
    TreeDelta delta;
    std::vector<Vec3> markers;
};

} // namespace espalier

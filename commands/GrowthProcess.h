// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthModel.h"

#include <span>
#include <vector>

namespace espalier {

/// Makes a tree grow step by step without a brush. A process keeps the state between its steps, but not the
/// tree: on equal trees its steps are equal, so they can be computed on a copy of the tree (GrowthReplica).
class GrowthProcess {
public:
    virtual ~GrowthProcess() = default;
    /// The next step of a tree to which all earlier steps were applied; empty if growth has come to its end.
    virtual TreeDelta step(const Tree& tree, const TreeIndex& index, const GrowthModel& model) = 0;
    /// World positions of the living markers of free space, m; none if markers live for one step only.
    virtual std::span<const Vec3> markers() const { return {}; }
};

/// A step and the markers that are left after it.
struct GrownStep {
    TreeDelta delta;
    std::vector<Vec3> markers;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "model/growth/GrowthIndex.h"
#include "model/growth/Tropism.h"

#include <functional>

namespace espalier {

/// Settings of a growth step; of() gives those of the tree's parameters.
struct GrowthStepOptions {
    Competitors competitors;
    DirectionWeights weights;
    Perception perception;
    double setPointAngle = 0.0; ///< θ, rad
    /// Buds with a smaller share of the greatest vigour do not grow, 0...1; at 1 only the most vigorous bud
    /// grows.
    double leastVigour = 0.0;
    /// Whether the step sheds branches.
    bool sheds = true;
    /// Whether young wood straightens, by the parameter; see straightenWood().
    bool straightens = true;
    /// Whether an internode may lead from one node to another, m; if empty, every internode may. A shoot that
    /// is refused ends, and the markers that its bud owns are removed.
    std::function<bool(const Vec3& from, const Vec3& to)> admits;
    /// Growth stays in the plane z = 0, as in a diagram: each bud turns about its axis into the plane, to the
    /// nearer side, and searches for free space there. Precondition: parameters without irregularity and with
    /// at most two laterals at a node.
    bool isPlanar = false;

    static GrowthStepOptions of(const GrowthParameters& parameters);
};

/// One growth step toward @p markers (TreeSketch §3.2). Buds compete for markers. Vigour decides how many
/// internodes n = ⌊v / v_max · n_max⌋ each enabled bud may add. Shoots add them in lockstep, with a new
/// competition before each, and stop where they find no free space. Branches that the new growth shades are
/// shed if their vigour per internode is below Th. Occupied markers are removed from @p markers. The delta is
/// empty if nothing grew.
TreeDelta growthStep(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth, MarkerSet& markers,
                     const GrowthStepOptions& options, GrowthWorkspace& workspace);

/// One growth step without a brush: markers are placed in the volume of perception of each bud that is
/// vigorous enough to grow (weaker buds could not use them); they last for this step only.
TreeDelta autonomousStep(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace);

/// n = ⌊v / v_max · n_max⌋; 0 if v_max is 0. Exactly n_max for v = v_max.
int shootLength(double vigour, double greatestVigour, int longest);

/// Grows @p bud toward a target that it does not perceive, by at most @p count internodes, until the tip is
/// within @p distance of @p target (both in m). The shoot stays bare of branches in this step.
TreeDelta growLeader(const Tree& tree, const TreeIndex& index, const BudRef& bud, const Vec3& target,
                     float distance, int count, GrowthWorkspace& workspace);

/// The last living internode of the trunk that begins with @p root.
InternodeId trunkTip(const TreeIndex& index, InternodeId root);

} // namespace espalier

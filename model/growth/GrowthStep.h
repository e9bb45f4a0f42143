// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "model/growth/GrowthIndex.h"
#include "model/growth/Tropism.h"

#include <functional>

namespace espalier {

/// How a growth step differs from what the tree's parameters say alone.
struct GrowthStepOptions {
    Competitors competitors;
    DirectionWeights weights;
    Perception perception;
    double setPointAngle = 0.0; ///< θ, rad
    /// Buds with less than this share of the greatest vigour stay dormant, 0...1: at 1 only the most vigorous
    /// bud grows.
    double leastVigour = 0.0;
    /// Whether shedding is part of the step.
    bool sheds = true;
    /// Whether an internode may lead from one node to another, m; empty lets all. A shoot that may not go on
    /// ends, and the markers that drew it there go.
    std::function<bool(const Vec3& from, const Vec3& to)> admits;
    /// Growth stays in the plane z = 0, as in a diagram: each bud turns about its axis into the plane, to the
    /// side that it is nearer to, and finds its free space there. For parameters without irregularity and
    /// with two laterals at a node at most.
    bool isPlanar = false;

    static GrowthStepOptions of(const GrowthParameters& parameters);
};

/// One step of growth toward @p markers (TreeSketch §3.2): buds compete for them; vigour decides how many
/// internodes n = ⌊v / v_max · n_max⌋ each enabled bud may add; shoots add theirs in lockstep, competing anew
/// for each, and stop where they find no free space; branches that the new growth puts in shadow are shed if
/// their vigour per internode is below Th. Occupied markers leave @p markers. The delta is empty if nothing
/// grew.
TreeDelta growthStep(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth, MarkerSet& markers,
                     const GrowthStepOptions& options, GrowthWorkspace& workspace);

/// One step of growth without a hand: markers appear in the volume of perception of each bud that is vigorous
/// enough to grow (others could not use them), and go with the step.
TreeDelta autonomousStep(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace);

/// n = ⌊v / v_max · n_max⌋, with 0 for a v_max of 0. Exact at v = v_max.
int shootLength(double vigour, double greatestVigour, int longest);

/// Lets @p bud grow toward @p target, @p count internodes at most, until the target is within @p distance (m)
/// of the tip: a shoot that is called by something it does not perceive. It stays bare of branches.
TreeDelta growLeader(const Tree& tree, const TreeIndex& index, const BudRef& bud, const Vec3& target,
                     float distance, int count, GrowthWorkspace& workspace);

/// The trunk's last living internode.
InternodeId trunkTip(const TreeIndex& index);

/// The same from the trunk's tip: the leader of a seedling that a distant brush calls.
TreeDelta growLeader(const Tree& tree, const TreeIndex& index, const Vec3& target, float distance, int count,
                     GrowthWorkspace& workspace);

} // namespace espalier

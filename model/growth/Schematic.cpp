// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Schematic.h"

#include "model/growth/GrowthStep.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// The number of growth steps: many for short shoots, few for long ones.
int stepsOf(const GrowthParameters& parameters)
{
    return std::clamp(45 / parameters.maxShootLength, 9, 24);
}

/// An internode also stands for those in front of and behind the plane, so it casts a multiple of its shadow.
constexpr double kShadowOfPlane = 3.0;
/// Straight down, a branch has no direction within the plane; so the set-point angle stays below that.
constexpr double kSteepest = radians(179.5);

GrowthParameters inPlane(GrowthParameters parameters)
{
    parameters.model = GrowthModelKind::TreeSketch;
    parameters.irregularity = 0.0;
    parameters.lateralsPerNode = std::min(parameters.lateralsPerNode, 2);
    parameters.setPointAngle = std::min(parameters.setPointAngle, kSteepest);
    parameters.shadowIntensity *= kShadowOfPlane;
    // The same number of markers per length in the plane as in space.
    parameters.markersPerBud = static_cast<int>(std::ceil(std::pow(parameters.markersPerBud, 2.0 / 3.0)));
    // A diagram has a fixed size, independent of the tree's.
    parameters.internodeLength = 1.0;
    return parameters;
}

Schematic grow(const GrowthParameters& parameters)
{
    TreeParameters all;
    all.growth = inPlane(parameters);
    Schematic schematic{Tree(1, all), {}};
    Tree& tree = schematic.tree;
    TreeIndex& index = schematic.index;
    index.rebuild(tree);
    GrowthIndex growth(tree, index);
    GrowthWorkspace workspace;

    int left = kMostOfSchematic;
    GrowthStepOptions options = GrowthStepOptions::of(all.growth);
    options.isPlanar = true;
    // Shoots grow in lockstep, so they all end together when no internodes are left.
    options.admits = [&left](const Vec3&, const Vec3&) { return left > 0 && left-- > 0; };
    for (int step = stepsOf(parameters); step > 0 && left > 0; --step) {
        TreeDelta delta = autonomousStep(tree, index, growth, options, workspace);
        if (delta.isEmpty())
            break;
        tree.apply(delta);
        index.update(tree, delta);
        growth.follow(tree, index, delta);
        growth.settle(tree, index);
    }
    return schematic;
}

} // namespace

Schematic growSchematic(const GrowthParameters& parameters)
{
    // On one thread: for so little work, waking other threads costs more than they save.
    return tbb::task_arena(1).execute([&] { return grow(parameters); });
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Schematic.h"

#include "model/growth/GrowthStep.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// As many steps as short shoots need to become a tree, and no more than long ones do.
int stepsOf(const GrowthParameters& parameters)
{
    return std::clamp(45 / parameters.maxShootLength, 9, 24);
}

/// An internode stands for those that a plane has no room for: it casts the shadow of so many.
constexpr double kShadowOfPlane = 3.0;
/// Straight down has no side: there the plane of a branch would be lost.
constexpr double kSteepest = radians(179.5);

GrowthParameters inPlane(GrowthParameters parameters)
{
    parameters.irregularity = 0.0;
    parameters.lateralsPerNode = std::min(parameters.lateralsPerNode, 2);
    parameters.setPointAngle = std::min(parameters.setPointAngle, kSteepest);
    parameters.shadowIntensity *= kShadowOfPlane;
    // As dense in the plane as they are in space.
    parameters.markersPerBud = static_cast<int>(std::ceil(std::pow(parameters.markersPerBud, 2.0 / 3.0)));
    // Its size is that of a diagram, whatever the tree's.
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
    // In lockstep: where the internodes give out, all shoots of the step end together.
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
    // On one thread: to wake others costs more than they give for so little.
    return tbb::task_arena(1).execute([&] { return grow(parameters); });
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/BundlePlaces.h"

#include "model/base/Parallel.h"
#include "model/strands/HexLattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

constexpr std::size_t kBundlesPerTask = 256;
/// Thinner strands would coincide in the precision of positions, m: the parameter counts as 0.
constexpr double kLeastStrandRadius = 1e-5;
/// The shift of a branch onto the surface of the one below it fades over this many radii of that one.
constexpr float kShiftRadii = 2.5F;
/// A shift below this share of that length counts as none.
constexpr float kLeastShift = 0.003F;
/// How far strands are rounded, in radii of the wood.
constexpr float kReachRadii = 1.5F;
/// The trunk's flare ends at this height, in radii.
constexpr float kFlareRadii = 3.5F;

void setRadii(StrandSkeleton& skeleton, const TreeParameters& parameters)
{
    const double wanted = parameters.wood.strandRadius;
    const auto fixed = static_cast<float>(wanted >= kLeastStrandRadius ? wanted : 0.0);
    const auto flare = static_cast<float>(parameters.widths.flare);
    for (StrandNode& node : skeleton.nodes) {
        if (fixed > 0.0F)
            node.radius = fixed * bundleRadius(node.strands);
    }
    for (const std::uint32_t base : skeleton.bases) {
        const float radius = skeleton.nodes[base].radius;
        const float end = kFlareRadii * radius;
        float path = 0.0F;
        for (std::uint32_t node = base; path < end;) {
            StrandNode& n = skeleton.nodes[node];
            const float rest = 1.0F - path / end;
            n.radius += flare * radius * rest * rest;
            const auto above = skeleton.childrenOf(node);
            if (above.empty())
                break;
            node = *std::ranges::max_element(above, {},
                                             [&](std::uint32_t c) { return skeleton.nodes[c].strands; });
            path += (skeleton.nodes[node].position - n.position).norm();
        }
    }
}

/// Stubs that are hardly longer than the wood that they stand on is thick are not thicker than their strands
/// in that wood: a disc on the bark would look like no branch.
void limitStubs(StrandSkeleton& skeleton)
{
    std::vector<StrandNode>& nodes = skeleton.nodes;
    std::vector<float> lengths(nodes.size(), 0.0F); // To the farthest tip, m
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (nodes[i].parent != i)
            lengths[nodes[i].parent] =
                std::max(lengths[nodes[i].parent],
                         lengths[i] + (nodes[i].position - nodes[nodes[i].parent].position).norm());
    }
    std::vector<float> limits(nodes.size(), std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        StrandNode& node = nodes[i];
        const StrandNode& parent = nodes[node.parent];
        if (node.parent == i)
            continue;
        limits[i] = limits[node.parent];
        if (2 * node.strands < parent.strands) {
            const float length = lengths[i] + (node.position - parent.position).norm();
            const float bySection = parent.radius / bundleRadius(parent.strands) * bundleRadius(node.strands);
            limits[i] = std::max(bySection, length - parent.radius);
        }
        node.radius = std::min(node.radius, limits[i]);
    }
}

void placeCentres(const StrandSkeleton& skeleton, const std::function<Vec2(std::uint32_t node)>& middleOf,
                  BundlePlaces& places)
{
    const std::vector<StrandNode>& nodes = skeleton.nodes;
    // The middle of each branch's strands in the section below it, against the middle of that section.
    std::vector<Vec3> shifts(nodes.size(), Vec3(Vec3::Zero()));
    parallelFor(nodes.size(), kBundlesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t parent = nodes[i].parent;
            if (parent == i || nodes[parent].childCount < 2)
                continue;
            const Vec2 middle = middleOf(static_cast<std::uint32_t>(i));
            shifts[i] = nodes[parent].frame * (places.scales[parent] * Vec3(middle.x(), 0.0F, middle.y()));
        }
    });
    places.centres.resize(nodes.size());
    std::vector<float> reach(nodes.size(), 0.0F);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const StrandNode& node = nodes[i];
        if (node.parent == i) {
            places.centres[i] = node.position;
            reach[i] = kShiftRadii * node.radius;
            continue;
        }
        const StrandNode& parent = nodes[node.parent];
        const bool isMain = 2 * node.strands >= parent.strands;
        reach[i] =
            isMain ? std::max(reach[node.parent], kShiftRadii * node.radius) : kShiftRadii * parent.radius;
        const float length = (node.position - parent.position).norm();
        Vec3 shift = places.centres[node.parent] - parent.position + shifts[i];
        shift *= std::exp(-length / std::max(reach[i], 1e-6F));
        // What is not seen ends, so a change at a fork reaches only the wood near it.
        if (shift.squaredNorm() < kLeastShift * kLeastShift * reach[i] * reach[i])
            shift.setZero();
        places.centres[i] = node.position + shift;
    }
}

void measureReaches(const StrandSkeleton& skeleton, BundlePlaces& places)
{
    const std::vector<StrandNode>& nodes = skeleton.nodes;
    places.reaches.assign(nodes.size(), 0.0F);
    std::vector<float> above(nodes.size(), std::numeric_limits<float>::max()); // To the nearest child
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const std::uint32_t parent = nodes[i].parent;
        if (parent == i)
            continue;
        const float length = (places.centres[i] - places.centres[parent]).norm();
        above[parent] = std::min(above[parent], length);
        places.reaches[i] = std::max(kReachRadii * nodes[i].radius, places.reaches[parent] - length);
        if (skeleton.isBase(parent))
            places.reaches[i] = kReachRadii * nodes[i].radius;
    }
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (const std::uint32_t parent = nodes[i].parent;
            parent == i || nodes[i].childCount == 0 ||
            std::min(above[i], (places.centres[i] - places.centres[parent]).norm()) >= places.reaches[i])
            places.reaches[i] = 0.0F;
    }
}

} // namespace

BundlePlaces placeBundles(StrandSkeleton& skeleton, const TreeParameters& parameters,
                          const std::function<Vec2(std::uint32_t node)>& middleOf)
{
    setRadii(skeleton, parameters);
    limitStubs(skeleton);
    BundlePlaces places;
    for (const StrandNode& node : skeleton.nodes)
        places.scales.push_back(node.radius / bundleRadius(node.strands));
    placeCentres(skeleton, middleOf, places);
    measureReaches(skeleton, places);
    return places;
}

} // namespace espalier

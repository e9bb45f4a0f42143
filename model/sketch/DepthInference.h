// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/SketchedTree.h"

#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace espalier {

/// How depths are chosen. The paper gives the factors; what it leaves open is marked as uncertain.
struct DepthOptions {
    /// Which branches must leave their parent sideways, within 45° of the drawing's plane as seen from above,
    /// so that the second tree fills what they leave free; without one, none must.
    enum class Sideways {
        None,
        FirstOrder,
        All, ///< Uncertain: the paper does not say whether the rule holds beyond the first order
    };
    /// What makes a place for a branch good.
    enum class Clearance {
        Mean,  ///< The mean distance from other branches (uncertain)
        Least, ///< The least distance, but for the part near the parent
    };

    std::uint64_t seed = 1;        ///< Of the order of siblings and of choices between equals
    bool secondTree = true;        ///< Whether the tree is placed twice, the second time turned by 90° (4.2)
    bool secondAvoidsFirst = true; ///< Whether the second tree avoids the branches of the first (uncertain)
    Sideways sideways = Sideways::All;
    Clearance clearance = Clearance::Mean;
    double hullMagnification = std::numbers::sqrt2; ///< Of the crown's hull (4.1)
    double lengthMagnification =
        1.2; ///< Of the longest length by Weber & Penn, from the second order on (4.1)
    double angleMagnification = 1.2; ///< Of the drawing's greatest angle between parent and child (4.1)
    double curvatureQuantile = 0.9;  ///< Of a stroke's curvature, which its curve has in space (uncertain)
    double elevationLimit = radians(45.0); ///< Of a curve's tangent relative to its chord's depth, rad
    bool bentTrunk = true; ///< Whether the trunk, too, is a curve in space; else it stays in the plane z = 0

    bool operator==(const DepthOptions&) const = default;
};

/// The rules that a branch breaks because no place within the limits was left.
struct BrokenRules {
    bool sideways = false;
    bool hull = false;
    bool length = false;
    bool angle = false;

    bool any() const { return sideways || hull || length || angle; }
    bool operator==(const BrokenRules&) const = default;
};

/// A branch in space.
struct PlacedBranch {
    SketchId source = 0; ///< The branch of the drawing
    std::optional<std::size_t>
        parent;            ///< Index in the placed branches, less than the branch's own; none: trunk
    int order = 0;         ///< 0: trunk
    double along = 0.0;    ///< 0...1, the base's share of the parent's arc length in space
    bool isTurned = false; ///< Whether it belongs to the second tree
    std::vector<Eigen::Vector3d>
        line;                  ///< m; a point for each point of the drawn line. The base lies on the parent
    std::vector<double> radii; ///< m, at even distances from base to tip, as drawn; empty: none was drawn
    BrokenRules broken;
};

/// A leaf in space.
struct PlacedLeaf {
    SketchId source = 0;
    std::size_t branch = 0; ///< Index in the placed branches
    double along = 0.0;     ///< 0...1, the base's share of the branch's arc length in space
    std::vector<Eigen::Vector3d>
        outline; ///< m, parallel to the drawing (or turned by 90°); the first is the base
};

struct PlacedTree {
    std::vector<PlacedBranch>
        branches; ///< The first tree in the drawing's order, then the second's but its trunk
    std::vector<PlacedLeaf> leaves;
};

/// The depths of a drawing's branches (Okabe 2005, 4.1 and 4.2). The branches spread so that they are as far
/// from each other as possible, in the projection to the ground: order by order, siblings in random order,
/// each branch gets one of the depths of its tip at which its straight segment has about the greatest
/// clearance in GroundDistances, among depths that put it within the CrownHull, not longer and at no wider
/// angle than the limits. If no depth satisfies all rules, the sideways rule is given up first, then hull,
/// length and angle, and those of length and angle are exceeded by as little as possible. No branch is left
/// out. Curves get the depths of constantCurvatureDepths() between base and tip; a trunk's are scaled so that
/// it is at most three times as crooked in depth as it was drawn (the paper does not say).
///
/// x and y of the first tree's points are the drawing's, exactly. The second tree is the same drawing, placed
/// again and turned by 90° around the vertical at the base of each branch of first order; it shares the
/// trunk.
///
/// One thread; the time is proportional to the number of branches. The result is a function of the arguments.
PlacedTree inferDepth(const SketchedTree& drawing, const DepthOptions& options = {});

} // namespace espalier

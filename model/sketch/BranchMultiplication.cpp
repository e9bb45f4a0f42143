// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchMultiplication.h"

#include "model/base/Random.h"
#include "model/sketch/BranchAxis.h"
#include "model/sketch/BranchCopy.h"
#include "model/sketch/SketchText.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace espalier {

namespace {

/// Neighbours that are nearer to each other than this share of the branch's length have no gap.
constexpr double kLeastNeighbourGap = 1e-4;
/// Kept from kMostFromUp, so that rounding does not exceed it, rad.
constexpr double kUpMargin = radians(0.01);
/// Rotation angles whose distances from the others differ by less are equally good, rad.
constexpr double kEqualAngles = radians(0.2);
/// Between equally good rotation angles, so many branches decide that begin nearest along the branch.
constexpr std::size_t kDecidingNeighbours = 4;

/// Where the new branch begins, and the branches beside that place.
struct Gap {
    double middle; ///< Arc length from the base, m
    const ChildBranch* below;
    const ChildBranch* above;
};

Gap widestGap(const std::vector<ChildBranch>& children, double length)
{
    const auto width = [&](std::size_t i) { return children[i].distance - children[i - 1].distance; };
    std::size_t widest = 1;
    for (std::size_t i = 2; i < children.size(); ++i) {
        if (width(i) > width(widest))
            widest = i;
    }
    if (children.size() > 1 && width(widest) > kLeastNeighbourGap * length) {
        const ChildBranch& below = children[widest - 1];
        const ChildBranch& above = children[widest];
        return {.middle = 0.5 * (below.distance + above.distance), .below = &below, .above = &above};
    }
    const double toBase = children.front().distance;
    const double toTip = length - children.back().distance;
    return {.middle = toBase > toTip ? 0.5 * toBase : length - 0.5 * toTip,
            .below = &children.front(),
            .above = &children.back()};
}

/// The distance of two angles on a circle, 0...π.
double betweenAngles(double a, double b)
{
    return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
}

/// The rotation angles at which a branch with a down angle is at most kMostFromUp from the upward direction:
/// those within halfWidth of middle.
struct AllowedAngles {
    double middle;
    double halfWidth;
};

/// @p up: the upward direction in the turtle's frame. Raises @p downAngle if no rotation angle is allowed.
AllowedAngles allowedAngles(const Eigen::Vector3d& up, double& downAngle)
{
    const double most = kMostFromUp - kUpMargin;
    const double parentFromUp = std::acos(std::clamp(up.y(), -1.0, 1.0));
    downAngle = std::max(downAngle, parentFromUp - most);
    // The cosine of the angle from up is a + b cos(rotation - middle).
    const double a = std::cos(downAngle) * up.y();
    const double b = std::sin(downAngle) * std::hypot(up.x(), up.z());
    const double least = std::cos(most);
    const double middle = std::atan2(up.z(), up.x());
    if (a - b >= least || b < 1e-9)
        return {.middle = middle, .halfWidth = std::numbers::pi};
    return {.middle = middle, .halfWidth = std::acos(std::clamp((least - a) / b, -1.0, 1.0))};
}

/// A rotation angle that a new branch may have, and its distance from the nearest other one, rad.
struct FreeAngle {
    double angle;
    double clearance;
};

/// The distance of an angle from the nearest of @p others, 0...π.
double clearanceOf(double angle, std::span<const double> others)
{
    double nearest = std::numbers::pi;
    for (const double other : others)
        nearest = std::min(nearest, betweenAngles(angle, other));
    return nearest;
}

/// The allowed angle that is farthest from @p others, all in rad; of equal ones, the one that is farthest
/// from the first few of @p others. So branches that follow each other along the parent do not stand on one
/// side of it. @p random decides where these are equal, too.
double freestAngle(const std::vector<double>& others, const AllowedAngles& allowed, Random& random)
{
    const bool isAnyAllowed = allowed.halfWidth >= std::numbers::pi;
    if (others.empty())
        return allowed.middle + random.uniform(-allowed.halfWidth, allowed.halfWidth);
    // The distance from the nearest one has its maxima at the middles of gaps and at the ends of what is
    // allowed.
    std::vector<double> sorted = others;
    std::ranges::sort(sorted);
    std::vector<FreeAngle> candidates;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double next = i + 1 < sorted.size() ? sorted[i + 1] : sorted.front() + 2.0 * std::numbers::pi;
        const double middle = 0.5 * (sorted[i] + next);
        if (isAnyAllowed || betweenAngles(middle, allowed.middle) <= allowed.halfWidth)
            candidates.push_back({middle, middle - sorted[i]});
    }
    if (!isAnyAllowed) {
        for (const double end : {allowed.middle - allowed.halfWidth, allowed.middle + allowed.halfWidth})
            candidates.push_back({end, clearanceOf(end, sorted)});
    }
    const auto keepFreest = [&candidates] {
        const double most = std::ranges::max(candidates, {}, &FreeAngle::clearance).clearance;
        std::erase_if(candidates,
                      [most](const FreeAngle& free) { return free.clearance < most - kEqualAngles; });
    };
    keepFreest();
    const std::span<const double> deciding =
        std::span(others).first(std::min(others.size(), kDecidingNeighbours));
    for (FreeAngle& free : candidates)
        free.clearance = clearanceOf(free.angle, deciding);
    keepFreest();
    return candidates[random.bits() % candidates.size()].angle;
}

/// The turtle's turn from a branch to a branch on it: around the parent, then away from it.
Eigen::Quaterniond turtleTurn(double rotationAngle, double downAngle)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(-rotationAngle, Eigen::Vector3d::UnitY()) *
                              Eigen::AngleAxisd(-downAngle, Eigen::Vector3d::UnitZ()));
}

} // namespace

Result<TreeDelta> multiplied(const Tree& tree, const TreeIndex& index, InternodeId id, std::uint64_t seed)
{
    if (!tree.isAlive(id))
        return Error{Error::Kind::Input, SketchText::tr("internode %1 is not alive").arg(id)};
    const BranchAxis axis(tree, index, id);
    const std::vector<ChildBranch> children = childBranches(tree, index, axis);
    if (children.empty())
        return Error{Error::Kind::Input,
                     SketchText::tr("the branch of internode %1 carries no branch to imitate").arg(id)};
    Random random(mixedBits(tree.key(axis.internodes().front()) ^ mixedBits(seed)), tree.step(),
                  Purpose::Direction);
    const ChildBranch& shape = children[random.bits() % children.size()];
    const Gap gap = widestGap(children, axis.length());

    std::vector<const ChildBranch*> around; // Those nearest along the branch first
    for (const ChildBranch& child : children) {
        if (std::sin(child.downAngle()) > 1e-3)
            around.push_back(&child);
    }
    std::ranges::stable_sort(
        around, {}, [&](const ChildBranch* child) { return std::abs(child->distance - gap.middle); });
    std::vector<double> others;
    for (const ChildBranch* child : around)
        others.push_back(child->rotationAngle());
    const BranchAxis::Place place = axis.at(gap.middle);
    const Eigen::Quaterniond& frame = axis.frame(place.number);
    double downAngle = 0.5 * (gap.below->downAngle() + gap.above->downAngle());
    const AllowedAngles allowed =
        allowedAngles(frame.conjugate() * Eigen::Vector3d(Eigen::Vector3d::UnitY()), downAngle);
    const double rotationAngle = freestAngle(others, allowed, random);

    const auto lengthOf = [&](const ChildBranch& child) {
        return BranchAxis(tree, index, child.id).length();
    };
    const double length = 0.5 * (lengthOf(*gap.below) + lengthOf(*gap.above));
    const InternodeId parent = axis.internodes()[place.number];
    const Eigen::Quaterniond world = frame * turtleTurn(rotationAngle, downAngle) *
                                     turtleTurn(shape.rotationAngle(), shape.downAngle()).conjugate() *
                                     axis.frame(shape.place.number).conjugate() *
                                     index.rotation(shape.id).cast<double>();
    const Eigen::Quaterniond local = index.rotation(parent).cast<double>().conjugate() * world;
    BranchCopies copies(tree, index);
    copies.add(shape.id, {.parent = parent,
                          .along = place.along,
                          .rotation = Rotation(local.normalized().cast<float>()),
                          .scale = length / lengthOf(shape)});
    return copies.finish();
}

} // namespace espalier

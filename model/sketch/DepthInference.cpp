// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/DepthInference.h"

#include "model/base/Random.h"
#include "model/sketch/ConstantCurvature.h"
#include "model/sketch/CrownHull.h"
#include "model/sketch/GroundDistances.h"
#include "model/sketch/WeberPenn.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace espalier {

namespace {

using Vector3 = Eigen::Vector3d;

/// Depths are tried on both sides in this many steps.
constexpr int kDepthSteps = 24;
/// A trunk's greatest distance from its chord, in depth, in those of the drawing.
constexpr double kMostCrooked = 3.0;
/// Places for a branch with this share of the best one's clearance are about as good.
constexpr double kAboutAsGood = 0.93;
/// Places that exceed the limits by that much more than the least are about as near to them.
constexpr double kAboutAsLittle = 0.02;

/// A random number of a branch in one of the two trees, of one use; a pure function of its arguments.
std::uint64_t branchBits(std::uint64_t seed, bool isSecond, SketchId branch, std::uint64_t use)
{
    constexpr std::uint64_t kSketch = 0x5ce7c4ed7ee5U; // Sets these numbers apart from those of growth
    return mixedBits(mixedBits(mixedBits(mixedBits(seed ^ kSketch) ^ (isSecond ? 1U : 0U)) ^ branch) ^ use);
}

Eigen::Vector2d onGround(const Vector3& point)
{
    return {point.x(), point.z()};
}

/// Turns a point by 90° around the vertical through another one: what was at the right comes to the front.
Vector3 turnedAround(const Vector3& axis, const Vector3& point)
{
    const Vector3 offset = point - axis;
    return axis + Vector3(-offset.z(), offset.y(), offset.x());
}

/// The inverse of turnedAround().
Vector3 turnedBack(const Vector3& axis, const Vector3& point)
{
    const Vector3 offset = point - axis;
    return axis + Vector3(offset.z(), offset.y(), -offset.x());
}

double angleOfSteps(const Vector3& a, const Vector3& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vector3 drawnPoint(const Eigen::Vector2d& point, double depth = 0.0)
{
    return {point.x(), point.y(), depth};
}

/// Makes a trunk at most kMostCrooked times as crooked in depth as it was drawn, measured by the greatest
/// distance from its chord, which is in the drawing's plane: the straight parts of a slightly crooked one
/// would bend far into depth.
void keepAboutAsCrooked(std::vector<Vector3>& line)
{
    const Eigen::Vector2d base = line.front().head<2>();
    const Eigen::Vector2d chord = (line.back().head<2>() - base).normalized();
    double drawn = 0.0;
    double deep = 0.0;
    for (const Vector3& point : line) {
        const Eigen::Vector2d offset = point.head<2>() - base;
        drawn = std::max(drawn, std::abs(chord.x() * offset.y() - chord.y() * offset.x()));
        deep = std::max(deep, std::abs(point.z()));
    }
    const double most = kMostCrooked * drawn;
    if (deep <= most)
        return;
    for (Vector3& point : line)
        point.z() *= most / deep;
}

/// What the drawing says about a branch.
struct BranchChord {
    std::size_t parent = 0; ///< Row; its own for the trunk
    int order = 0;
    Vector3 step = Vector3::Zero(); ///< From base to tip, in the drawing
};

/// The place on a curve of space at a share of its drawn line's length.
struct PlaceInSpace {
    Vector3 point;
    double along = 0.0; ///< 0...1, share of the length in space
};

PlaceInSpace placeInSpace(const std::vector<Vector3>& curve, const std::vector<double>& drawnShares,
                          double share)
{
    double before = 0.0;
    double whole = 0.0;
    Vector3 point = curve.front();
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const double from = drawnShares[i - 1];
        const double to = drawnShares[i];
        const Vector3 step = curve[i] - curve[i - 1];
        if (share > from) {
            const double part = share >= to || to <= from ? 1.0 : (share - from) / (to - from);
            point = curve[i - 1] + part * step;
            before = whole + part * step.norm();
        }
        whole += step.norm();
    }
    return {.point = point, .along = whole > 0.0 ? std::min(before / whole, 1.0) : 0.0};
}

/// What both trees share: measures of the drawing.
class DrawingMeasures {
public:
    DrawingMeasures(const SketchedTree& drawing, const DepthOptions& options)
        : m_hull(allPoints(drawing), options.hullMagnification)
    {
        const std::vector<SketchedBranch>& branches = drawing.branches();
        std::vector<BranchLength> lengths;
        for (std::size_t i = 0; i < branches.size(); ++i) {
            const SketchedBranch& branch = branches[i];
            m_shares.push_back(arcShares(branch.line));
            BranchChord chord{
                .parent = i, .order = 0, .step = drawnPoint(branch.line.back() - branch.line.front())};
            if (branch.parent) {
                const auto found =
                    std::ranges::lower_bound(branches, *branch.parent, {}, &SketchedBranch::id);
                chord.parent = static_cast<std::size_t>(found - branches.begin());
                const BranchChord& parent = m_chords[chord.parent];
                chord.order = parent.order + 1;
                m_angleLimit = std::max(m_angleLimit, angleOfSteps(parent.step, chord.step));
                const double parentLength = parent.step.norm();
                lengths.push_back({.order = chord.order,
                                   .length = chord.step.norm(),
                                   .parentLength = parentLength,
                                   .offset = branch.along * parentLength});
            }
            m_chords.push_back(chord);
        }
        m_angleLimit = std::min(options.angleMagnification * m_angleLimit, std::numbers::pi);
        m_lengthShares = drawnLengthShares(lengths);
        for (double& share : m_lengthShares)
            share *= options.lengthMagnification;
    }

    const CrownHull& hull() const { return m_hull; }
    const BranchChord& chord(std::size_t row) const { return m_chords[row]; }
    const std::vector<double>& shares(std::size_t row) const { return m_shares[row]; }
    double angleLimit() const { return m_angleLimit; }
    /// The greatest length of a branch; without a limit for the trunk and its children.
    double lengthLimit(int order, double parentLength, double offset) const
    {
        return order < 2 ? std::numeric_limits<double>::infinity()
                         : childLength(m_lengthShares[static_cast<std::size_t>(order)], parentLength, offset);
    }

private:
    static SketchLine allPoints(const SketchedTree& drawing)
    {
        SketchLine points;
        for (const SketchedBranch& branch : drawing.branches())
            points.insert(points.end(), branch.line.begin(), branch.line.end());
        return points;
    }

    CrownHull m_hull;
    std::vector<BranchChord> m_chords;
    std::vector<std::vector<double>> m_shares; ///< Of the drawn lines
    std::vector<double> m_lengthShares;        ///< By order, magnified
    double m_angleLimit = 0.0;                 ///< rad, magnified
};

/// Places the branches of a drawing one after the other.
class BranchPlacing {
public:
    BranchPlacing(const SketchedTree& drawing, const DrawingMeasures& measures, const DepthOptions& options,
                  bool isSecond)
        : m_drawing(drawing),
          m_measures(measures),
          m_options(options),
          m_isSecond(isSecond),
          m_field(measures.hull().footprint()),
          m_placed(drawing.branches().size())
    {
    }

    /// Keeps the placed branches away from a segment.
    void avoid(const Vector3& from, const Vector3& to) { m_field.stamp(onGround(from), onGround(to)); }

    /// The branches, in the drawing's order.
    std::vector<PlacedBranch> place()
    {
        for (const std::size_t row : placingOrder()) {
            if (m_measures.chord(row).order == 0)
                placeTrunk(row);
            else
                placeBranch(row);
            avoid(m_placed[row].line.front(), m_placed[row].line.back());
        }
        return std::move(m_placed);
    }

private:
    /// Order by order; in an order the children of one parent after those of another, in random order.
    std::vector<std::size_t> placingOrder() const
    {
        const std::vector<SketchedBranch>& branches = m_drawing.branches();
        std::vector<std::vector<std::size_t>> children(branches.size());
        for (std::size_t row = 1; row < branches.size(); ++row)
            children[m_measures.chord(row).parent].push_back(row);
        std::vector<std::size_t> order{0};
        for (std::size_t i = 0; i < order.size(); ++i) {
            std::vector<std::size_t>& siblings = children[order[i]];
            std::ranges::sort(siblings, {}, [&](std::size_t row) {
                return branchBits(m_options.seed, m_isSecond, branches[row].id, 0);
            });
            order.insert(order.end(), siblings.begin(), siblings.end());
        }
        return order;
    }

    void placeTrunk(std::size_t row)
    {
        // Both trees have the same trunk.
        PlacedBranch& trunk = started(row);
        const std::uint64_t bits = branchBits(m_options.seed, false, trunk.source, 1);
        trunk.line = curve(row, 0.0, 0.0, m_options.bentTrunk ? ((bits & 1U) != 0 ? 1.0 : -1.0) : 0.0);
        keepAboutAsCrooked(trunk.line);
    }

    void placeBranch(std::size_t row)
    {
        const SketchedBranch& drawn = m_drawing.branches()[row];
        const std::size_t parentRow = m_measures.chord(row).parent;
        PlacedBranch& branch = started(row);
        const PlaceInSpace base =
            placeInSpace(m_placed[parentRow].line, m_measures.shares(parentRow), drawn.along);
        branch.parent = parentRow;
        branch.along = base.along;
        Random random(branchBits(m_options.seed, m_isSecond, drawn.id, 2), 0, Purpose::Direction);

        struct Candidate {
            double depth;
            double score;
            BrokenRules broken;
            double excess;
        };
        std::vector<Candidate> candidates;
        int leastBroken = std::numeric_limits<int>::max();
        double leastExcess = std::numeric_limits<double>::infinity();
        for (const double depth : depthsToTry(row, base.point)) {
            const Vector3 tip = drawnPoint(drawn.line.back(), depth);
            double excess = 0.0;
            const BrokenRules broken = brokenBy(row, base, tip, excess);
            // The rule that is given up first counts least.
            const int rank = (broken.sideways ? 1 : 0) + (broken.hull ? 2 : 0) + (broken.length ? 4 : 0) +
                             (broken.angle ? 8 : 0);
            if (rank > leastBroken)
                continue;
            if (rank < leastBroken) {
                candidates.clear();
                leastBroken = rank;
                leastExcess = excess;
            }
            leastExcess = std::min(leastExcess, excess);
            const GroundDistances::Clearance clearance =
                m_field.clearance(onGround(base.point), onGround(tip));
            const double score =
                m_options.clearance == DepthOptions::Clearance::Mean ? clearance.mean : clearance.least;
            candidates.push_back({depth, score, broken, excess});
        }
        // A limit that must be broken is broken by as little as possible, or about that.
        std::erase_if(candidates,
                      [&](const Candidate& one) { return one.excess > leastExcess + kAboutAsLittle; });
        const double bestScore = std::ranges::max(candidates, {}, &Candidate::score).score;
        // Each of those about as good as the best is taken with the same probability, so that seeds differ.
        std::erase_if(candidates, [&](const Candidate& one) { return one.score < kAboutAsGood * bestScore; });
        const auto chosen =
            static_cast<std::size_t>(random.uniform() * static_cast<double>(candidates.size()));
        const Candidate& taken = candidates[std::min(chosen, candidates.size() - 1)];
        const double tipDepth = taken.depth;
        branch.broken = taken.broken;
        branch.line = betterSide(row, base.point.z(), tipDepth, random);
    }

    PlacedBranch& started(std::size_t row)
    {
        const SketchedBranch& drawn = m_drawing.branches()[row];
        PlacedBranch& branch = m_placed[row];
        branch.source = drawn.id;
        branch.order = m_measures.chord(row).order;
        branch.radii = drawn.radii;
        branch.isTurned = m_isSecond;
        return branch;
    }

    bool isSidewaysRule(int order) const
    {
        return m_options.secondTree &&
               (m_options.sideways == DepthOptions::Sideways::All ||
                (m_options.sideways == DepthOptions::Sideways::FirstOrder && order == 1));
    }

    /// Depths for the tip: evenly through the hull and, under the sideways rule, through the range it leaves,
    /// with both limits and the depth of the base.
    std::vector<double> depthsToTry(std::size_t row, const Vector3& base) const
    {
        std::vector<double> depths;
        const double reach = m_measures.hull().footprint().max().y();
        const double aside = std::abs(m_drawing.branches()[row].line.back().x() - base.x());
        const bool isRule = isSidewaysRule(m_measures.chord(row).order);
        depths.push_back(base.z());
        for (int i = -kDepthSteps; i <= kDepthSteps; ++i) {
            const double share = static_cast<double>(i) / kDepthSteps;
            depths.push_back(share * reach);
            if (isRule && i != 0)
                depths.push_back(base.z() + share * aside);
        }
        return depths;
    }

    /// The rules that a branch breaks with its tip there. @p excess: by how much it exceeds the limits of
    /// length, as a share of it, and angle, rad, together.
    BrokenRules brokenBy(std::size_t row, const PlaceInSpace& base, const Vector3& tip, double& excess) const
    {
        const BranchChord& chord = m_measures.chord(row);
        const std::vector<Vector3>& parent = m_placed[chord.parent].line;
        const Vector3 parentStep = parent.back() - parent.front();
        const Vector3 step = tip - base.point;
        const double slack = 1e-9 * (1.0 + step.norm());
        BrokenRules broken;
        broken.sideways = isSidewaysRule(chord.order) && std::abs(step.z()) > std::abs(step.x()) + slack;
        for (const double share : {0.25, 0.5, 0.75, 1.0})
            broken.hull = broken.hull || !m_measures.hull().contains(base.point + share * step);
        const double parentLength = parentStep.norm();
        const double longest =
            m_measures.lengthLimit(chord.order, parentLength, m_drawing.branches()[row].along * parentLength);
        const double angle = angleOfSteps(parentStep, step);
        broken.length = step.norm() > longest + slack;
        broken.angle = angle > m_measures.angleLimit() + 1e-9;
        excess = (broken.length ? step.norm() / std::max(longest, slack) - 1.0 : 0.0) +
                 (broken.angle ? angle - m_measures.angleLimit() : 0.0);
        return broken;
    }

    /// The curve in space between two depths; @p side 0: with no bend out of its plane.
    std::vector<Vector3> curve(std::size_t row, double baseDepth, double tipDepth, double side) const
    {
        const SketchLine& line = m_drawing.branches()[row].line;
        const double end = tipDepth - baseDepth;
        std::vector<Vector3> points;
        if (side == 0.0) {
            const std::vector<double>& shares = m_measures.shares(row);
            for (std::size_t i = 0; i < line.size(); ++i)
                points.push_back(drawnPoint(line[i], baseDepth + shares[i] * end));
        } else {
            const std::vector<double> depths =
                constantCurvatureDepths(line, {.elevationLimit = m_options.elevationLimit,
                                               .quantile = m_options.curvatureQuantile,
                                               .side = side,
                                               .endDepth = end});
            for (std::size_t i = 0; i < line.size(); ++i)
                points.push_back(drawnPoint(line[i], baseDepth + depths[i]));
        }
        points.back().z() = tipDepth;
        return points;
    }

    /// The curve that bends to the side that is farther from other branches.
    std::vector<Vector3> betterSide(std::size_t row, double baseDepth, double tipDepth, Random& random) const
    {
        std::vector<Vector3> front = curve(row, baseDepth, tipDepth, 1.0);
        std::vector<Vector3> back = curve(row, baseDepth, tipDepth, -1.0);
        const auto clearance = [&](const std::vector<Vector3>& points) {
            double sum = 0.0;
            for (const Vector3& point : points)
                sum += m_field.at(onGround(point));
            return sum;
        };
        const double difference = clearance(front) - clearance(back);
        const bool isFront = difference == 0.0 ? random.uniform() < 0.5 : difference > 0.0;
        return isFront ? front : back;
    }

    const SketchedTree& m_drawing;
    const DrawingMeasures& m_measures;
    const DepthOptions& m_options;
    bool m_isSecond;
    GroundDistances m_field;
    std::vector<PlacedBranch> m_placed;
};

/// Adds the leaves that the branch at an index carries. @p axis: of the second tree's turn.
void placeLeaves(PlacedTree& tree, const SketchedTree& drawing, std::size_t branch,
                 const std::vector<double>& drawnShares, const std::vector<Vector3>& unturned,
                 const Vector3& axis)
{
    for (const SketchedLeaf& leaf : drawing.leaves()) {
        if (leaf.branch != tree.branches[branch].source)
            continue;
        const PlaceInSpace base = placeInSpace(unturned, drawnShares, leaf.along);
        PlacedLeaf placed{.source = leaf.id, .branch = branch, .along = base.along, .outline = {}};
        for (const Eigen::Vector2d& point : leaf.outline) {
            const Vector3 inSpace = drawnPoint(point, base.point.z());
            placed.outline.push_back(tree.branches[branch].isTurned ? turnedAround(axis, inSpace) : inSpace);
        }
        tree.leaves.push_back(std::move(placed));
    }
}

} // namespace

PlacedTree inferDepth(const SketchedTree& drawing, const DepthOptions& options)
{
    PlacedTree tree;
    if (drawing.isEmpty())
        return tree;
    const DrawingMeasures measures(drawing, options);
    tree.branches = BranchPlacing(drawing, measures, options, false).place();
    const std::size_t count = tree.branches.size();
    for (std::size_t row = 0; row < count; ++row)
        placeLeaves(tree, drawing, row, measures.shares(row), tree.branches[row].line, Vector3::Zero());
    if (!options.secondTree)
        return tree;

    // The vertical around which the second tree's branches turn goes through the base of the branch of first
    // order that they belong to.
    std::vector<Vector3> axes(count, tree.branches.front().line.front());
    for (std::size_t row = 1; row < count; ++row) {
        const PlacedBranch& branch = tree.branches[row];
        axes[row] = branch.order == 1 ? branch.line.front() : axes[*branch.parent];
    }
    BranchPlacing second(drawing, measures, options, true);
    if (options.secondAvoidsFirst) {
        for (std::size_t row = 1; row < count; ++row) {
            const std::vector<Vector3>& line = tree.branches[row].line;
            second.avoid(turnedBack(axes[row], line.front()), turnedBack(axes[row], line.back()));
        }
    }
    std::vector<PlacedBranch> turned = second.place();
    for (std::size_t row = 1; row < count; ++row) {
        PlacedBranch branch = std::move(turned[row]);
        const std::vector<Vector3> unturned = branch.line;
        for (Vector3& point : branch.line)
            point = turnedAround(axes[row], point);
        if (*branch.parent != 0)
            branch.parent = *branch.parent + count - 1; // The second tree has no trunk of its own
        tree.branches.push_back(std::move(branch));
        placeLeaves(tree, drawing, tree.branches.size() - 1, measures.shares(row), unturned, axes[row]);
    }
    return tree;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/SketchSkeleton.h"

#include "model/tree/TreeTables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace espalier {

namespace {

using SpaceCurve = std::vector<Eigen::Vector3d>;

double curveLength(const SpaceCurve& curve)
{
    double length = 0.0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += (curve[i] - curve[i - 1]).norm();
    return length;
}

/// The ends of @p pieces pieces of a curve of a length, base first.
SpaceCurve pieceEnds(const SpaceCurve& curve, double length, std::size_t pieces)
{
    SpaceCurve ends{curve.front()};
    double passed = 0.0;
    std::size_t segment = 1;
    for (std::size_t i = 1; i < pieces; ++i) {
        const double place = length * static_cast<double>(i) / static_cast<double>(pieces);
        double here = (curve[segment] - curve[segment - 1]).norm();
        while (segment + 1 < curve.size() && passed + here < place) {
            passed += here;
            ++segment;
            here = (curve[segment] - curve[segment - 1]).norm();
        }
        const double share = here > 0.0 ? std::clamp((place - passed) / here, 0.0, 1.0) : 0.0;
        ends.emplace_back(curve[segment - 1] + share * (curve[segment] - curve[segment - 1]));
    }
    ends.push_back(curve.back());
    return ends;
}

/// The drawn radius at a share of a branch's length, m; 0 without any.
float radiusAt(const std::vector<double>& radii, double share)
{
    if (radii.empty())
        return 0.0F;
    const double place = share * static_cast<double>(radii.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), radii.size() - 1);
    const std::size_t above = std::min(below + 1, radii.size() - 1);
    const double radius = std::lerp(radii[below], radii[above], place - static_cast<double>(below));
    return static_cast<float>(std::min(radius, 0.5 * double{kGreatestDiameter}));
}

/// How the branches of a tree are divided into pieces.
struct BranchPieces {
    std::vector<double> lengths; ///< m, of the branches
    std::vector<std::size_t> counts;
    std::vector<std::size_t> firsts; ///< Indices of their first pieces among all

    /// The piece at a share of a branch's length.
    std::size_t pieceAt(std::size_t branch, double along) const
    {
        const auto place = static_cast<std::size_t>(along * static_cast<double>(counts[branch]));
        return firsts[branch] + std::min(place, counts[branch] - 1);
    }
};

BranchPieces branchPiecesOf(const PlacedTree& tree, double internodeLength)
{
    BranchPieces pieces;
    double whole = 0.0;
    for (const PlacedBranch& branch : tree.branches) {
        pieces.lengths.push_back(curveLength(branch.line));
        whole += pieces.lengths.back();
    }
    // Each branch has at most one piece more than its length asks for.
    const double spare =
        std::max(1.0, static_cast<double>(kMostSegments) - static_cast<double>(pieces.lengths.size()));
    const double pieceLength = std::max(internodeLength, whole / spare);
    std::size_t first = 0;
    for (const double length : pieces.lengths) {
        pieces.counts.push_back(static_cast<std::size_t>(std::max(1.0, std::round(length / pieceLength))));
        pieces.firsts.push_back(first);
        first += pieces.counts.back();
    }
    return pieces;
}

} // namespace

Skeleton skeletonOf(const PlacedTree& tree, double internodeLength)
{
    const BranchPieces pieces = branchPiecesOf(tree, internodeLength);
    Skeleton skeleton;
    for (std::size_t i = 0; i < tree.branches.size(); ++i) {
        const PlacedBranch& branch = tree.branches[i];
        const std::size_t count = pieces.counts[i];
        std::uint32_t carrier = kNoInternode;
        if (branch.parent)
            carrier = static_cast<std::uint32_t>(pieces.pieceAt(*branch.parent, branch.along));
        const SpaceCurve ends = pieceEnds(branch.line, pieces.lengths[i], count);
        for (std::size_t j = 0; j < count; ++j) {
            const double share = static_cast<double>(j + 1) / static_cast<double>(count);
            skeleton.push_back({.parent = carrier,
                                .base = ends[j].cast<float>(),
                                .tip = ends[j + 1].cast<float>(),
                                .radius = radiusAt(branch.radii, share)});
            carrier = static_cast<std::uint32_t>(skeleton.size() - 1);
        }
    }
    return skeleton;
}

std::vector<SkeletonLeaf> skeletonLeavesOf(const PlacedTree& tree, double internodeLength)
{
    const BranchPieces pieces = branchPiecesOf(tree, internodeLength);
    std::vector<SkeletonLeaf> leaves;
    for (const PlacedLeaf& leaf : tree.leaves) {
        const Eigen::Vector3d viewer = tree.branches[leaf.branch].isTurned
                                           ? Eigen::Vector3d(-Eigen::Vector3d::UnitX())
                                           : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
        if (const std::optional<LeafBlade> blade = bladeOf(leaf.outline, viewer))
            leaves.push_back({.segment = static_cast<std::uint32_t>(pieces.pieceAt(leaf.branch, leaf.along)),
                              .base = leaf.outline.front().cast<float>(),
                              .blade = *blade});
    }
    return leaves;
}

} // namespace espalier

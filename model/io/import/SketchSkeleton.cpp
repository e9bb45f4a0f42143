// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/SketchSkeleton.h"

#include "model/sketch/CurvePieces.h"
#include "model/tree/TreeTables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace espalier {

namespace {

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
    std::vector<CurvePieces> branches;
    std::vector<std::size_t> firsts; ///< Indices of their first pieces among all

    /// The piece at a share of a branch's length.
    std::size_t pieceAt(std::size_t branch, double along) const
    {
        const std::vector<double>& shares = branches[branch].shares;
        const auto next = std::upper_bound(shares.begin() + 1, shares.end() - 1, along);
        return firsts[branch] + static_cast<std::size_t>(next - shares.begin()) - 1;
    }
};

BranchPieces branchPiecesOf(const PlacedTree& tree, double internodeLength)
{
    double whole = 0.0;
    for (const PlacedBranch& branch : tree.branches)
        whole += curveLength(branch.line);
    // Each branch may have more pieces than its length asks for.
    const double spare = std::max(1.0, static_cast<double>(kMostSegments) -
                                           static_cast<double>(kMostCurvePieces * tree.branches.size()));
    const double pieceLength = std::max(internodeLength, whole / spare);
    Eigen::AlignedBox3d box;
    for (const PlacedBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.line)
            box.extend(point);
    }
    const double tolerance = kDrawingTolerance * box.sizes().head<2>().maxCoeff();
    BranchPieces pieces;
    std::size_t first = 0;
    for (const PlacedBranch& branch : tree.branches) {
        pieces.branches.push_back(curvePieces(branch.line, pieceLength, tolerance));
        pieces.firsts.push_back(first);
        first += pieces.branches.back().ends.size() - 1;
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
        const CurvePieces& division = pieces.branches[i];
        std::uint32_t carrier = kNoInternode;
        if (branch.parent)
            carrier = static_cast<std::uint32_t>(pieces.pieceAt(*branch.parent, branch.along));
        for (std::size_t j = 0; j + 1 < division.ends.size(); ++j) {
            skeleton.push_back({.parent = carrier,
                                .base = division.ends[j].cast<float>(),
                                .tip = division.ends[j + 1].cast<float>(),
                                .radius = radiusAt(branch.radii, division.shares[j + 1])});
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

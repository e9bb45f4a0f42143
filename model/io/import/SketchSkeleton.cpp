// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/SketchSkeleton.h"

#include "model/tree/TreeTables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

} // namespace

Skeleton skeletonOf(const PlacedTree& tree, double internodeLength)
{
    std::vector<double> lengths;
    double whole = 0.0;
    for (const PlacedBranch& branch : tree.branches) {
        lengths.push_back(curveLength(branch.line));
        whole += lengths.back();
    }
    // Each branch has at most one piece more than its length asks for.
    const double spare =
        std::max(1.0, static_cast<double>(kMostSegments) - static_cast<double>(lengths.size()));
    const double pieceLength = std::max(internodeLength, whole / spare);

    Skeleton skeleton;
    std::vector<std::size_t> firstPiece;
    std::vector<std::size_t> pieces;
    for (std::size_t i = 0; i < tree.branches.size(); ++i) {
        const PlacedBranch& branch = tree.branches[i];
        const auto count = static_cast<std::size_t>(std::max(1.0, std::round(lengths[i] / pieceLength)));
        firstPiece.push_back(skeleton.size());
        pieces.push_back(count);
        std::uint32_t carrier = kNoInternode;
        if (branch.parent) {
            const double place = branch.along * static_cast<double>(pieces[*branch.parent]);
            const std::size_t piece = std::min(static_cast<std::size_t>(place), pieces[*branch.parent] - 1);
            carrier = static_cast<std::uint32_t>(firstPiece[*branch.parent] + piece);
        }
        const SpaceCurve ends = pieceEnds(branch.line, lengths[i], count);
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

} // namespace espalier

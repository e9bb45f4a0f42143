// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandNode.h"
#include "model/tree/Parameters.h"

#include <functional>
#include <vector>

namespace espalier {

/// Where the bundle of strands lies at each node of a skeleton.
struct BundlePlaces {
    std::vector<float> scales; ///< Length of a strand radius, m
    /// World position of the middle, m. Where a branch leaves a thick one, it lies on that one's surface, and
    /// approaches the branch's own line further up.
    std::vector<Vec3> centres;
    /// How far the wood's line is rounded to either side, m: about as far as the wood is thick, and near a
    /// fork as far as that is. 0 where the next nodes are farther.
    std::vector<float> reaches;

    std::size_t bytes() const
    {
        return scales.capacity() * sizeof(float) + centres.capacity() * sizeof(Vec3) +
               reaches.capacity() * sizeof(float);
    }
};

/// Places the bundles, and makes the radii of the nodes those of the bundles: of fixed strands, or of the
/// branches, with a trunk's flare. @p middleOf: the middle of the strands of a node in the section of the
/// node below it, in strand radii.
BundlePlaces placeBundles(StrandSkeleton& skeleton, const TreeParameters& parameters,
                          const std::function<Vec2(std::uint32_t node)>& middleOf);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthStep.h"

#include <memory>

namespace espalier {

/// A way in which trees grow. A model has an index of what it derives from a tree, which follows the tree's
/// deltas, and returns growth steps as deltas. A document has one model at a time and may change it between
/// two steps, because everything that a step produces is in the tree.
class GrowthModel {
public:
    virtual ~GrowthModel() = default;

    /// A model of the same kind with an empty index: for another tree, or for a copy on another thread.
    virtual std::unique_ptr<GrowthModel> fresh() const = 0;

    /// Makes the index from scratch.
    virtual void rebuild(const Tree& tree, const TreeIndex& index) = 0;
    /// Notes the changes of @p delta, which @p tree and @p index have just applied or reverted. To be called
    /// for each delta, and settle() before the next query.
    virtual void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta) = 0;
    /// Updates the index by about @p nodes nodes; returns whether it is up to date.
    virtual bool settleSome(const Tree& tree, const TreeIndex& index, std::size_t nodes) = 0;
    void settle(const Tree& tree, const TreeIndex& index)
    {
        settleSome(tree, index, std::numeric_limits<std::size_t>::max());
    }
    /// The voxels with light and nodes. Precondition: the index is settled.
    virtual const VoxelSpace& space() const = 0;
    /// Memory of the index in bytes.
    virtual std::size_t bytes() const = 0;

    /// One growth step without a brush. Empty if no bud may grow. Precondition: the index is settled.
    virtual TreeDelta growFreely(const Tree& tree, const TreeIndex& index, const GrowthStepOptions& options,
                                 GrowthWorkspace& workspace) const = 0;
    /// One growth step toward @p markers of free space, m; removes the markers that are occupied afterwards.
    /// Empty if nothing grew. Precondition: the index is settled.
    virtual TreeDelta growToward(const Tree& tree, const TreeIndex& index, MarkerSet& markers,
                                 const GrowthStepOptions& options, GrowthWorkspace& workspace) const = 0;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthStep.h"

#include <memory>

namespace espalier {

/// How a tree grows. A model keeps what it has to know of a tree in an index of its own, which follows the
/// tree's deltas, and makes growth steps as deltas. A document has one at a time and may change it between
/// two steps: all that a step leaves is in the tree.
class GrowthModel {
public:
    virtual ~GrowthModel() = default;

    /// A model of the same kind whose index is empty: for another tree, or for a copy on another thread.
    virtual std::unique_ptr<GrowthModel> fresh() const = 0;

    /// Makes the index anew.
    virtual void rebuild(const Tree& tree, const TreeIndex& index) = 0;
    /// Notes what @p delta, which @p tree and @p index have just applied or reverted, has changed. To be
    /// called for each delta, and settle() before the next question.
    virtual void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta) = 0;
    /// Brings the index up to date, about @p nodes nodes of it; returns whether nothing is left.
    virtual bool settleSome(const Tree& tree, const TreeIndex& index, std::size_t nodes) = 0;
    void settle(const Tree& tree, const TreeIndex& index)
    {
        settleSome(tree, index, std::numeric_limits<std::size_t>::max());
    }
    /// The light around the tree. Precondition: the index is settled.
    virtual const VoxelSpace& space() const = 0;
    /// Of memory, for the index.
    virtual std::size_t bytes() const = 0;

    /// One step without a hand. Empty if no bud may grow. Precondition: the index is settled.
    virtual TreeDelta growFreely(const Tree& tree, const TreeIndex& index, const GrowthStepOptions& options,
                                 GrowthWorkspace& workspace) const = 0;
    /// One step toward @p markers of free space, m; those that are occupied afterwards leave the set. Empty
    /// if nothing grew. Precondition: the index is settled.
    virtual TreeDelta growToward(const Tree& tree, const TreeIndex& index, MarkerSet& markers,
                                 const GrowthStepOptions& options, GrowthWorkspace& workspace) const = 0;
};

} // namespace espalier

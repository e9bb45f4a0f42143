// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/shape/ChainBend.h"
#include "model/tree/TreeIndex.h"

#include <span>
#include <vector>

namespace espalier {

/// The internodes from @p base to @p end along parent links, both included; empty unless @p end is @p base or
/// in its subtree.
std::vector<InternodeId> pathBetween(const Tree& tree, InternodeId base, InternodeId end);

/// What bending did to the row of an internode; all that hangs on it moves along.
struct FrameChange {
    InternodeId id;
    Rotation before; ///< Local frame
    Rotation after;
    float lengthBefore; ///< m
    float lengthAfter;  ///< m
};

/// A branch of a tree while hands bend it (TreeSketch §3.3): the path from a base internode, which stays, to
/// an end internode, as a ChainBend. What hangs on the path keeps its frames against the internodes that
/// carry it. The rest pose, and the rows that changes() counts from, are those of the tree at construction,
/// whatever is applied to the tree later.
class BranchBend {
public:
    /// Where a hand holds the branch.
    struct Handle {
        InternodeId id = kNoInternode; ///< On the path, above the base; another holds nothing
        double along = 1.0;            ///< 0...1 from its lower to its upper node

        bool operator==(const Handle&) const = default;
    };

    BranchBend(const Tree& tree, const TreeIndex& index, InternodeId base, InternodeId end,
               std::span<const Handle> handles, const BendOptions& options = {});

    /// Base to end. A path of less than two internodes does not bend.
    std::span<const InternodeId> path() const { return m_path; }
    /// World position of a handle at rest, m: what its target is to be measured from.
    Vec3 restPoint(const Handle& handle) const;

    /// See ChainBend::solve; @p targets in the order of the handles, m.
    bool solve(std::span<const Vec3> targets);
    void reset() { m_chain.reset(); }
    const ChainPose& pose() const { return m_chain.pose(); }

    /// What the rows of the path's internodes must become for the tree to stand as pose() says; none of those
    /// that stay as they are, never the base's. A length is never less than a hundredth of what it was, and
    /// never beyond what a tree may hold.
    std::vector<FrameChange> changes() const;

private:
    std::vector<InternodeId> m_path;
    std::vector<Rotation> m_rotations; ///< Local, at rest
    std::vector<float> m_lengths;
    ChainBend m_chain;
};

} // namespace espalier

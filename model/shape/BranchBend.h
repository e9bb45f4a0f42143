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

/// The change of an internode's row by bending; everything that hangs on the internode moves along.
struct FrameChange {
    InternodeId id;
    Rotation before; ///< Local frame
    Rotation after;
    float lengthBefore; ///< m
    float lengthAfter;  ///< m
};

/// A branch of a tree during a bend (TreeSketch §3.3): the path from a base internode, which stays, to an end
/// internode, as a ChainBend. Branches that hang on the path keep their frames relative to the internodes
/// that carry them. The rest pose, and the rows that changes() compares with, are those of the tree at
/// construction, even if the tree changes later.
class BranchBend {
public:
    /// A place at which a pointer or a pin holds the branch.
    struct Handle {
        InternodeId id = kNoInternode; ///< On the path, above the base; a handle elsewhere has no effect
        double along = 1.0;            ///< 0...1 from its lower to its upper node

        bool operator==(const Handle&) const = default;
    };

    BranchBend(const Tree& tree, const TreeIndex& index, InternodeId base, InternodeId end,
               std::span<const Handle> handles, const BendOptions& options = {});

    /// Base to end. A path of less than two internodes does not bend.
    std::span<const InternodeId> path() const { return m_path; }
    /// World position of a handle at rest, m: the displacement of its target counts from here.
    Vec3 restPoint(const Handle& handle) const;

    /// See ChainBend::solve; @p targets in the order of the handles, m.
    bool solve(std::span<const Vec3> targets);
    void reset() { m_chain.reset(); }
    const ChainPose& pose() const { return m_chain.pose(); }

    /// The changes of the path's internodes that bring the tree into pose(), without internodes that stay as
    /// they are; the base always stays. A new length is at least a hundredth of the old one, and at most the
    /// longest that a tree can have.
    std::vector<FrameChange> changes() const;

private:
    std::vector<InternodeId> m_path;
    std::vector<Rotation> m_rotations; ///< Local, at rest
    std::vector<float> m_lengths;
    ChainBend m_chain;
};

} // namespace espalier

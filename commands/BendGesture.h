// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BendOperation.h"
#include "model/document/Edit.h"
#include "model/shape/BranchBend.h"

#include <vector>

namespace espalier {

/// A drag that bends a branch (TreeSketch §3.3): the path from a base internode, which stays, to the
/// uppermost handle. The tree follows at each call. finish() makes the whole drag one undo step; cancel()
/// takes it back, and so does the destructor of an unfinished gesture. Another edit that begins finishes it.
class BendGesture {
public:
    /// Handles that are not on a path from @p base have no effect; if none is left, nothing bends.
    BendGesture(TreeDocument& document, InternodeId base, std::vector<BranchBend::Handle> handles,
                const BendOptions& options = {});

    /// Continues with another base and other handles. The present form is the new rest pose.
    void regrip(InternodeId base, std::vector<BranchBend::Handle> handles);

    /// Where the handles were when they were gripped, m; in the order in which they were given.
    const std::vector<Vec3>& gripPoints() const { return m_gripPoints; }
    /// The internodes from the base to the uppermost handle; empty if nothing bends.
    std::span<const InternodeId> path() const { return m_bend.path(); }

    /// Pulls the handles, in the order given, to @p targets, m: see ChainBend::solve. A handle without a
    /// target is held where it was gripped. Returns whether the form has settled; if not, another call brings
    /// it nearer.
    bool moveTo(std::span<const Vec3> targets);
    /// Pulls until the form has settled, at most kMostPulls times.
    void settleAt(std::span<const Vec3> targets);
    static constexpr int kMostPulls = 200;

    void finish();
    void cancel() { m_edit.cancel(); }

private:
    static BranchBend bendOf(const TreeDocument& document, InternodeId base,
                             std::span<const BranchBend::Handle> handles, const BendOptions& options);
    void measure(std::span<const BranchBend::Handle> handles);
    /// The grip as a recipe has it, without the handles that have no effect.
    BendOperation::Grip gripOf(InternodeId base, std::span<const BranchBend::Handle> handles);
    /// Records that the branch is pulled to @p targets once, or, if @p settles, until it has settled. Returns
    /// the targets as a recipe has them.
    std::vector<Vec3> note(std::span<const Vec3> targets, bool settles);
    BendOperation operation() const;
    void show();
    void apply(const std::vector<FrameChange>& changes);

    Edit m_edit;
    BendOptions m_options;
    BranchBend m_bend;
    std::vector<Vec3> m_gripPoints;
    std::vector<BendOperation::Grip> m_grips; ///< All grips so far
    std::vector<std::size_t> m_holding;       ///< Indices of the present handles that have an effect
    std::vector<FrameChange> m_shown;         ///< The changes that are applied
    std::vector<FrameChange> m_done;          ///< The changes by earlier grips, by ascending id
};

} // namespace espalier

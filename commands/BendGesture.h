// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BendOperation.h"
#include "model/document/Edit.h"
#include "model/shape/BranchBend.h"

#include <vector>

namespace espalier {

/// A branch in the hands of a person who bends it (TreeSketch §3.3): the path from a base internode, which
/// stays, to the uppermost handle. The tree follows at each call; finish() makes the whole drag one undo
/// step, cancel() takes it back, and so does the end of an unfinished gesture.
class BendGesture {
public:
    /// Handles that are not on the path hold nothing; if none is left, nothing bends.
    BendGesture(TreeDocument& document, InternodeId base, std::vector<BranchBend::Handle> handles,
                const BendOptions& options = {});

    /// Other hands go on from the form that stands: it is the one that springs back to, from now on.
    void regrip(InternodeId base, std::vector<BranchBend::Handle> handles);

    /// Where the handles were when they were gripped, m; in the order given.
    const std::vector<Vec3>& gripPoints() const { return m_gripPoints; }
    /// Base to end; empty if nothing bends.
    std::span<const InternodeId> path() const { return m_bend.path(); }

    /// Pulls the handles (in the order given) to @p targets, m: see ChainBend::solve. Returns whether the
    /// form has settled; if not, calling again brings it nearer, at most kMostCalls times.
    bool moveTo(std::span<const Vec3> targets);
    /// The same until it has settled.
    void settleAt(std::span<const Vec3> targets);
    static constexpr int kMostCalls = 200;

    void finish();
    void cancel() { m_edit.cancel(); }

private:
    static BranchBend bendOf(const TreeDocument& document, InternodeId base,
                             std::span<const BranchBend::Handle> handles, const BendOptions& options);
    void measure(std::span<const BranchBend::Handle> handles);
    /// The grip as a recipe keeps it, without handles that hold nothing.
    BendOperation::Grip gripOf(InternodeId base, std::span<const BranchBend::Handle> handles);
    /// Notes that the branch is pulled to @p targets once, or, if @p settles, until it has settled. Returns
    /// the targets as a recipe keeps them.
    std::vector<Vec3> note(std::span<const Vec3> targets, bool settles);
    BendOperation operation() const;
    void show();
    void apply(const std::vector<FrameChange>& changes);

    Edit m_edit;
    BendOptions m_options;
    BranchBend m_bend;
    std::vector<Vec3> m_gripPoints;
    std::vector<BendOperation::Grip> m_grips; ///< So far
    std::vector<std::size_t> m_holding;       ///< Of the handles gripped now, those of the last of m_grips
    std::vector<FrameChange> m_shown;         ///< What stands applied
    std::vector<FrameChange> m_done;          ///< By the grips before, ascending
};

} // namespace espalier

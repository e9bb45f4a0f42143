// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "model/document/Edit.h"
#include "model/growth/GrowthStep.h"

namespace espalier {

/// The hand on the slider of time (TreeSketch §3.1, §3.3): back, the tree ungrows, edit by edit and growth
/// step by growth step; forward, it comes back, and beyond the present it grows on its own. Nothing is lost
/// by looking: only what is done at an earlier moment starts another future. finish() makes all of it one
/// undo step (travel and growth are two), cancel() takes it back, and so does destroying the gesture
/// unfinished.
class TimeGesture {
public:
    /// @p interrupted: what to do when another edit begins, instead of finish(); it must finish or cancel the
    /// gesture.
    explicit TimeGesture(TreeDocument& document, Edit::Interrupted interrupted = {});

    /// Goes to where @p position deltas have been applied; positions beyond the history grow as many steps,
    /// until there is no more room to grow in.
    void moveTo(std::size_t position);
    void finish();
    void cancel() { m_edit.cancel(); }

    /// Deltas of the history when the gesture began, the future included.
    std::size_t historyLength() const { return m_historyLength; }

private:
    bool grow();

    Edit m_edit;
    std::size_t m_historyLength;
    Competitors m_competitors; ///< Of the steps that have grown beyond the history
    BudReference m_only;       ///< The same
    GrowthWorkspace m_workspace;
};

} // namespace espalier

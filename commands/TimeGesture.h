// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BudReference.h"
#include "model/document/Edit.h"
#include "model/growth/GrowthStep.h"

namespace espalier {

/// A drag of the time slider (TreeSketch §3.1, §3.3). Backward, the tree ungrows, edit by edit and growth
/// step by growth step; forward, it returns, and beyond the history it grows freely. Travelling loses
/// nothing: only a change at an earlier moment ends the future. finish() makes the gesture one undo step;
/// cancel() takes it back, and so does the destructor of an unfinished gesture.
class TimeGesture {
public:
    /// @p interrupted is called when another edit begins; it must finish or cancel the gesture. If it is
    /// empty, the gesture finishes.
    explicit TimeGesture(TreeDocument& document, Edit::Interrupted interrupted = {});

    /// Travels to where @p position deltas are applied. A position beyond the history is reached by growth
    /// steps, as far as there is space to grow in.
    void moveTo(std::size_t position);
    void finish();
    void cancel() { m_edit.cancel(); }

    /// Number of deltas in the history when the gesture began, with the future.
    std::size_t historyLength() const { return m_historyLength; }

private:
    bool grow();

    Edit m_edit;
    std::size_t m_historyLength;
    Competitors m_competitors; ///< For the steps beyond the history
    BudReference m_only;       ///< The same
    GrowthWorkspace m_workspace;
};

} // namespace espalier

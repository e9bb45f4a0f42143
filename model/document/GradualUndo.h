// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"

#include <chrono>
#include <functional>

namespace espalier {

/// Takes a document's undo stack to another index in slices of time, so that no event waits for all of a
/// command with many deltas. It holds the document's edit until it is there. What interrupts it (another
/// edit, saving, TreeDocument::undo() and redo()) finds the stack at the wanted index.
class GradualUndo {
public:
    /// A command that changes fewer rows is undone in one slice, on a slow machine as well. A row counts if
    /// it is born, dies or moves; each delta counts as another one.
    static constexpr std::size_t kLeastRows = 1'000;
    /// A slice ends when more rows have changed: the growth index has as much to do with them as the tree.
    static constexpr std::size_t kMostRows = 6'000;

    /// Interrupts the edit that is under way, and begins. @p interrupted is called after the rest has been
    /// done because of an interruption; it may destroy this object.
    GradualUndo(TreeDocument& document, int index, std::function<void()> interrupted = {});
    /// Does all that is left.
    ~GradualUndo();
    GradualUndo(const GradualUndo&) = delete;
    GradualUndo& operator=(const GradualUndo&) = delete;

    /// Reverts or applies deltas, at least one, until @p time has passed and @p rows have changed, or brings
    /// the growth index up to date with what the slice before has taken out; returns whether any deltas are
    /// left.
    bool advance(std::chrono::milliseconds time, std::size_t rows = kLeastRows);
    /// Does all that is left.
    void finish();

private:
    bool step();

    TreeDocument& m_document;
    int m_index;
    Edit m_edit;                  ///< Changes nothing by itself
    std::size_t m_rows = 0;       ///< Changed in this slice
    bool m_isIndexBehind = false; ///< The growth index, by the last slice
    QMetaObject::Connection m_counting;
};

} // namespace espalier

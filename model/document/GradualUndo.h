// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"

#include <chrono>
#include <functional>

namespace espalier {

/// Takes a document's undo stack to another index in slices of time, so that events do not wait for a whole
/// command with many deltas. It holds the document's edit until it is done. An interruption (another edit,
/// saving, TreeDocument::undo() and redo()) makes it do the rest first.
class GradualUndo {
public:
    /// A slice changes at least this many rows, on a slow machine as well, so a command that changes fewer is
    /// undone in one slice. A row counts if it is born, dies or moves; each delta counts as another row.
    static constexpr std::size_t kLeastRows = 1'000;
    /// A slice ends when more rows have changed: the next one must update the growth index for all of them.
    static constexpr std::size_t kMostRows = 6'000;

    /// Interrupts the edit that is under way, and begins. @p interrupted is called after an interruption has
    /// made it do the rest; it may destroy this object.
    GradualUndo(TreeDocument& document, int index, std::function<void()> interrupted = {});
    /// Calls finish().
    ~GradualUndo();
    GradualUndo(const GradualUndo&) = delete;
    GradualUndo& operator=(const GradualUndo&) = delete;

    /// Does one slice; returns whether more slices are needed. Slices alternate: one reverts or applies
    /// deltas, at least one, until @p time has passed and @p rows rows have changed; the next updates the
    /// growth index for these rows.
    bool advance(std::chrono::milliseconds time, std::size_t rows = kLeastRows);
    /// Takes the stack to the wanted index without further slices, and ends the edit.
    void finish();

private:
    bool step();

    TreeDocument& m_document;
    int m_index;
    Edit m_edit;                  ///< Keeps other edits out; changes nothing itself
    std::size_t m_rows = 0;       ///< Number of rows changed in this slice
    bool m_isIndexBehind = false; ///< Whether the growth index must follow the last slice
    QMetaObject::Connection m_counting;
};

} // namespace espalier

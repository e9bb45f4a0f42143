// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

namespace espalier::test {

/// What of the document's indices differs from freshly made ones, in all that can be asked of them; empty if
/// nothing.
QString indexFault(const TreeDocument& document);

/// All of a document that undo and redo bring back.
struct DocumentState {
    explicit DocumentState(const TreeDocument& document)
        : tree(document.tree()), journal(document.journal().size()), undoIndex(document.undoStack().index())
    {
    }
    /// Exactly this, to the last bit.
    bool operator==(const DocumentState& other) const = default;

    Tree tree;
    std::size_t journal;
    int undoIndex;
};

/// In what @p document shows something else than @p before, empty if in nothing. Rows and parameters that
/// came since may be there but must neither live nor be in force.
QString visibleDifference(const DocumentState& before, const TreeDocument& document);

} // namespace espalier::test

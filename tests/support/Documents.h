// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

namespace espalier::test {

/// The difference between the document's indices and new ones, in all that can be queried; empty if there is
/// none.
QString indexFault(const TreeDocument& document);

/// The state of a document that undo and redo restore.
struct DocumentState {
    explicit DocumentState(const TreeDocument& document);
    /// Equal to the last bit.
    bool operator==(const DocumentState& other) const = default;

    Tree tree;
    std::vector<TreeDelta> journal;
    std::vector<TreeDelta> future;
    int undoIndex;
};

/// The difference between @p document and @p before, or between its indices and new ones; empty if there is
/// none.
QString differenceFrom(const DocumentState& before, const TreeDocument& document);

/// Applies @p delta as an undo step.
void apply(TreeDocument& document, TreeDelta delta);
/// Travels to the moment after the first @p position deltas, as an undo step.
void travel(TreeDocument& document, std::size_t position);

} // namespace espalier::test

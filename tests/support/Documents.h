// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/growth/GrowthIndex.h"

namespace espalier::test {

/// What the document's growth model knows of its tree.
const GrowthIndex& growthIndexOf(const TreeDocument& document);

/// What of the document's indices differs from freshly made ones, in all that can be asked of them; empty if
/// nothing.
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

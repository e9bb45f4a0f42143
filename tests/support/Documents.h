// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/growth/SelfOrganisingModel.h"

namespace espalier::test {

/// What the model that documents start with knows of the document's tree.
const GrowthIndex& growthIndexOf(const TreeDocument& document);

/// What of the document's indices differs from freshly made ones, in all that can be asked of them; empty if
/// nothing.
QString indexFault(const TreeDocument& document);

/// All of a document that undo and redo bring back.
struct DocumentState {
    explicit DocumentState(const TreeDocument& document);
    /// Exactly this, to the last bit.
    bool operator==(const DocumentState& other) const = default;

    Tree tree;
    std::vector<TreeDelta> journal;
    std::vector<TreeDelta> future;
    int undoIndex;
};

/// In what @p document differs from @p before, or its indices from freshly made ones; empty if in nothing.
QString differenceFrom(const DocumentState& before, const TreeDocument& document);

/// Applies @p delta as an undo step.
void apply(TreeDocument& document, TreeDelta delta);
/// Goes to where @p position deltas have been applied, as an undo step.
void travel(TreeDocument& document, std::size_t position);

} // namespace espalier::test

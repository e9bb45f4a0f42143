// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthModel.h"
#include "model/picking/PickIndex.h"
#include "model/scene/SceneLook.h"
#include "model/tree/JournalEdit.h"
#include "model/tree/Tree.h"
#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <QString>

#include <optional>
#include <vector>

namespace espalier {

/// An undo step that a history tells of.
struct RestoredStep {
    QString title;
    JournalEdit deltas; ///< Of the history; none in the last step of a document that shows an earlier moment
};

/// A tree with its history and all that a document derives from it, ready for TreeDocument::reset(). It
/// belongs to no document, so a worker thread can make it.
struct PreparedTree {
    /// @p journal: all deltas that led to @p tree. The last @p ahead of them will be the document's future.
    /// Precondition: ahead <= journal.size().
    PreparedTree(Tree tree, Journal journal, std::size_t ahead = 0);
    /// Nothing, to be filled: not ready yet.
    PreparedTree() = default;
    /// Also makes the index for picking, which a document otherwise makes at the first query.
    void preparePicking() { pickIndex.settle(tree, index); }

    Tree tree{};
    Journal journal;
    Journal future; ///< See TreeDocument::future()
    TreeIndex index;
    std::unique_ptr<GrowthModel> growthModel;
    PickIndex pickIndex;
    std::optional<SceneLook> look{}; ///< None if the tree comes without one
    std::vector<RestoredStep> steps; ///< The undo steps that the document will have, all of them done
};

} // namespace espalier

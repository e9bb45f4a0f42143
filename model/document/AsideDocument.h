// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/EditCommand.h"
#include "model/document/PreparedTree.h"

#include <vector>

namespace espalier {

/// All that a document consists of, undo stack included, while another tree takes its place.
struct AsideDocument {
    /// Takes all out of @p document, which becomes a seedling. Ends the edit that is under way.
    static AsideDocument takenFrom(TreeDocument& document);
    /// Makes @p document what it was; uses this value up.
    void bringBackTo(TreeDocument& document);

    struct Step {
        QString text;
        EditCommand::Content content;
    };

    /// The steps of a document's undo stack.
    static std::vector<Step> stepsOf(const TreeDocument& document);
    /// Fills the undo stack, which is empty, of a document that is in the state after the step before index.
    void fillStack(TreeDocument& document);

    PreparedTree tree; ///< With its history and its look
    std::vector<Step> steps;
    int index = 0;      ///< Of the undo stack: the steps before it are done, those after it are undone
    int cleanIndex = 0; ///< Likewise; -1 if no step leads to what is saved
    int undoLimit = 0;
};

} // namespace espalier

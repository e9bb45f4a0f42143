// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/NewNumbers.h"
#include "model/tree/Tree.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace espalier {

/// The rows of reverted deltas, as a snapshot holds them: the document's thread writes TreeDelta::rows.
using RowsOfDeltas = std::unordered_map<const TreeDelta*, std::shared_ptr<const TreeRows>>;

/// Takes out of a tree what only the beginning of its history knew: internodes and leaves that were dead at a
/// moment, and kept values that nothing refers to from that moment on. All else keeps its order.
///
/// To be used in this order: constructed; copyOf() for each delta that will go on existing; finish(); tree().
class Renumbering {
public:
    /// @param tree the tree after @p journal
    /// @param first the moment: the number of the journal's deltas that are dropped
    Renumbering(Tree tree, const Journal& journal, std::size_t first, const RowsOfDeltas& rows);

    /// A copy of a delta of any history that branches off at the moment or later. It is whole after finish().
    std::shared_ptr<TreeDelta> copyOf(const std::shared_ptr<TreeDelta>& delta);
    /// Fails only if the tree or the history was not sound.
    Result<void> finish();

    /// The tree in its new numbers.
    Tree& tree() { return m_tree; }
    const NewNumbers& internodes() const { return m_internodes; }

private:
    void keepWhatLives(const Tree& base);
    void keepWhatCopiesName();
    void keepWhatRowsName();
    void giveNumbers();
    Result<void> renumberTree();

    Tree m_tree;
    const RowsOfDeltas& m_rows;
    std::unordered_map<const TreeDelta*, std::shared_ptr<TreeDelta>> m_copies;
    NewNumbers m_internodes;
    NewNumbers m_leaves;
    NewNumbers m_parameters;
    NewNumbers m_lassos;
    NewNumbers m_profiles;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace espalier {

/// The rows of reverted deltas, as a snapshot holds them: the document's thread writes TreeDelta::rows.
using RowsOfDeltas = std::unordered_map<const TreeDelta*, std::shared_ptr<const TreeRows>>;

/// New numbers of the rows, or values, of one kind: those before `old.size()` have the number that stands
/// there, or are gone; all later ones move down by the number of those that are gone.
class NewNumbers {
public:
    static constexpr std::uint32_t kGone = ~std::uint32_t{0};

    /// @p count rows, none of which is kept yet.
    explicit NewNumbers(std::size_t count = 0) : m_numbers(count, kGone) {}

    std::uint32_t count() const { return static_cast<std::uint32_t>(m_numbers.size()); }
    void keep(std::uint32_t number)
    {
        if (number < m_numbers.size())
            m_numbers[number] = 0;
    }
    bool isKept(std::uint32_t number) const
    {
        return number >= m_numbers.size() || m_numbers[number] != kGone;
    }
    /// Gives the rows that are kept their numbers, in the old order.
    void number();
    /// The new number of a row that is kept. kNoInternode stays what it is.
    std::uint32_t operator[](std::uint32_t old) const
    {
        if (old < m_numbers.size())
            return m_numbers[old];
        return old == kNoInternode ? old : old - m_gone;
    }

private:
    std::vector<std::uint32_t> m_numbers;
    std::uint32_t m_gone = 0;
};

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

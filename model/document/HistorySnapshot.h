// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/AsideDocument.h"
#include "model/document/Renumbering.h"
#include "model/document/TreeDocument.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A document without the oldest part of its history, for TreeDocument::shorten(): the same tree under new
/// ids. Its time begins at a later moment, and undo goes back less far.
struct ShortenedHistory {
    std::uint64_t revision = 0; ///< Of the document that it was made from
    AsideDocument document{};   ///< Without a look, the clean index and the undo limit
    NewNumbers internodes{};    ///< Ids of the document that it was made from; those of the living are kept
    int steps = 0;              ///< Of the undo stack that are gone
    std::size_t deltas = 0;     ///< Of the journal that are gone
};

/// A document's history as it is now, to be measured and shortened on any thread.
class HistorySnapshot {
public:
    /// Copies a few bytes for each delta. Precondition: no edit of @p document is under way.
    explicit HistorySnapshot(const TreeDocument& document);

    /// The memory of all that undo, redo and travels in time can bring back, bytes: deltas, internodes that
    /// are dead or undone, trees that were exchanged.
    std::size_t bytes() const;
    /// The memory of an internode that is dead or undone, bytes.
    std::size_t rowBytes() const { return m_rowBytes; }
    /// The document without so much of its oldest history that about three quarters of @p most bytes are
    /// left. The last few undo steps stay, and all that can be redone. Empty if the history takes less than
    /// @p most, or little of it can be dropped.
    std::optional<ShortenedHistory> shortenedTo(std::size_t most) const;
    /// The document without the first @p deltas of its journal, and the undo steps that lead there or
    /// exchange the tree. Precondition: deltas <= the journal's size, and no undone step leads there.
    std::optional<ShortenedHistory> without(std::size_t deltas) const;

private:
    /// Where a history can be cut: undo steps and deltas that are dropped.
    struct Cut {
        std::size_t steps;
        std::size_t deltas;
    };

    void addRows(const Journal& deltas);
    void findReach();
    std::size_t memoryOfStep(std::size_t step) const;
    std::size_t memoryOf(const TreeDelta& delta) const;
    std::size_t memoryOf(const Journal& deltas) const;
    bool isOfThisTree(std::size_t step) const { return step >= m_firstOfTree && step < m_endOfTree; }
    std::optional<ShortenedHistory> shortenedAt(Cut cut) const;

    std::uint64_t m_revision;
    Tree m_tree;
    Journal m_journal;
    Journal m_future; ///< See TreeDocument::future()
    std::vector<AsideDocument::Step> m_steps;
    std::size_t m_index;
    RowsOfDeltas m_rows;
    std::size_t m_rowBytes; ///< Of an internode, with its share of the indices
    std::unordered_map<const PreparedTree*, std::size_t> m_otherBytes; ///< Of trees that were exchanged
    /// The steps that belong to the tree that is shown, and not to one that an exchange took away or brings.
    std::size_t m_firstOfTree = 0;
    std::size_t m_endOfTree = 0;
    /// By undo step: the first moment of the history that it, or a step after it, leads to.
    std::vector<std::size_t> m_reach;
};

} // namespace espalier

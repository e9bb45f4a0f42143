// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/io/project/HistoryChange.h"

#include <chrono>
#include <optional>
#include <unordered_map>
#include <vector>

namespace espalier {

/// Finds how the history of a document has changed since it was last asked. It keeps no copy of the tree, and
/// its work is in proportion to the change: it copies the rows of new deltas, and shares the deltas.
class HistoryFollower {
public:
    explicit HistoryFollower(const TreeDocument& document) : m_document(document) {}

    /// What the document has now is known; the deltas' numbers begin anew.
    void start();
    /// Number of deltas that are known.
    std::size_t size() const { return m_history.size(); }
    /// Whether there is a change to collect.
    bool isBehind() const;
    /// The deltas' numbers begin anew, as in a project that holds what is known.
    void renumber();
    /// The change since the last one, or since start(). It stops after about @p budget, and returns nothing;
    /// the next call goes on, also if more has been done meanwhile. Deltas of an edit under way count.
    std::optional<HistoryChange> collect(std::chrono::microseconds budget);

private:
    /// A delta of the history. A delta that has got a record since counts as another one.
    struct Entry {
        std::shared_ptr<TreeDelta> delta;
        const EditRecord* record = nullptr;
        bool operator==(const Entry&) const = default;
    };
    struct Number {
        std::weak_ptr<TreeDelta> delta;
        const EditRecord* record = nullptr;
        std::uint32_t number = 0;
    };

    std::vector<Entry> history() const;
    std::optional<std::uint32_t> numberOf(const Entry& entry) const;
    void learn(const Entry& entry);
    std::shared_ptr<const TreeRows> rowsOf(const Entry& entry, const KeptCounts& firstValue) const;

    const TreeDocument& m_document;
    std::vector<Entry> m_history; ///< At the last change
    std::unordered_map<const TreeDelta*, Number> m_numbers;
    std::uint32_t m_next = 0;
    std::uint32_t m_ahead = 0;
    SceneLook m_look;

    /// What has been collected so far of the next change.
    std::vector<Entry> m_seen; ///< The whole history when a part of it was last collected
    std::vector<std::shared_ptr<const TreeRows>> m_rows;
};

} // namespace espalier

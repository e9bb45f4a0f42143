// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/HistoryFollower.h"

#include <algorithm>

namespace espalier {

namespace {

KeptCounts countsOf(const KeptValues& values)
{
    KeptCounts counts;
    KeptTable::visit([](const auto&, const auto& column,
                        std::uint32_t& count) { count = static_cast<std::uint32_t>(column.size()); },
                     values, counts);
    return counts;
}

void takeAway(KeptCounts& counts, const KeptCounts& less)
{
    KeptTable::visit([](const auto&, std::uint32_t& count, std::uint32_t by) { count -= by; }, counts, less);
}

} // namespace

std::vector<HistoryFollower::Entry> HistoryFollower::history() const
{
    const Journal& journal = m_document.journal();
    const Journal& future = m_document.future();
    std::vector<Entry> entries;
    entries.reserve(journal.size() + future.size());
    for (const auto& delta : journal)
        entries.push_back({delta, delta->record.get()});
    for (auto delta = future.rbegin(); delta != future.rend(); ++delta)
        entries.push_back({*delta, (*delta)->record.get()});
    return entries;
}

void HistoryFollower::learn(const Entry& entry)
{
    m_numbers[entry.delta.get()] = {entry.delta, entry.record, m_next++};
}

std::optional<std::uint32_t> HistoryFollower::numberOf(const Entry& entry) const
{
    const auto known = m_numbers.find(entry.delta.get());
    // Another delta may have got the place in memory of one that is no more.
    if (known == m_numbers.end() || known->second.delta.lock() != entry.delta ||
        known->second.record != entry.record)
        return std::nullopt;
    return known->second.number;
}

void HistoryFollower::start()
{
    m_history = history();
    m_ahead = static_cast<std::uint32_t>(m_document.future().size());
    m_look = m_document.look();
    renumber();
    m_seen.clear();
    m_rows.clear();
}

void HistoryFollower::renumber()
{
    m_numbers.clear();
    m_next = 0;
    for (const Entry& entry : m_history)
        learn(entry);
}

bool HistoryFollower::isBehind() const
{
    return m_document.future().size() != m_ahead || m_document.look() != m_look || history() != m_history;
}

/// The rows and values of a delta, from the delta itself or from the tree, which has them while the delta is
/// applied.
std::shared_ptr<const TreeRows> HistoryFollower::rowsOf(const Entry& entry,
                                                        const KeptCounts& firstValue) const
{
    const TreeDelta& delta = *entry.delta;
    if (!delta.bringsRows())
        return nullptr;
    if (delta.rows)
        return std::make_shared<const TreeRows>(*delta.rows);
    const TreeContent& content = m_document.tree().content();
    auto rows = std::make_shared<TreeRows>();
    InternodeTable::visit([&](const auto&, const auto& column,
                              auto& piece) { piece = column.mid(delta.born.first, delta.born.count); },
                          content.internodes, rows->internodes);
    LeafTable::visit([&](const auto&, const auto& column,
                         auto& piece) { piece = column.mid(delta.bornLeaves.first, delta.bornLeaves.count); },
                     content.leaves, rows->leaves);
    KeptTable::visit([](const auto&, const auto& column, auto& piece, std::uint32_t first,
                        std::uint32_t count) { piece = column.mid(first, count); },
                     content.kept, rows->kept, firstValue, delta.kept);
    return rows;
}

std::optional<HistoryChange> HistoryFollower::collect(std::chrono::microseconds budget)
{
    const auto begun = std::chrono::steady_clock::now();
    const std::vector<Entry> now = history();
    // Rows that were collected may have values from deltas that were there then. If one of those is gone, the
    // rows are collected again.
    const bool goesOn = m_seen.size() <= now.size() && std::equal(m_seen.begin(), m_seen.end(), now.begin());
    if (!goesOn)
        m_rows.clear();
    m_seen = now;

    HistoryChange change;
    const auto kept = static_cast<std::size_t>(std::ranges::mismatch(m_history, now).in2 - now.begin());
    change.kept = static_cast<std::uint32_t>(kept);
    std::size_t first = kept;
    for (; first < now.size(); ++first) {
        const std::optional<std::uint32_t> number = numberOf(now[first]);
        if (!number)
            break;
        change.known.push_back(*number);
    }

    // Where the values of each delta begin, from the last delta that is applied back to the first one.
    const std::size_t fresh = now.size() - first;
    std::vector<KeptCounts> values(fresh);
    KeptCounts counts = countsOf(m_document.tree().content().kept);
    for (std::size_t i = fresh; i-- > m_rows.size();) {
        const TreeDelta& delta = *now[first + i].delta;
        if (first + i < m_document.journal().size())
            takeAway(counts, delta.kept);
        values[i] = counts;
    }
    while (m_rows.size() < fresh) {
        m_rows.push_back(rowsOf(now[first + m_rows.size()], values[m_rows.size()]));
        if (std::chrono::steady_clock::now() - begun > budget && m_rows.size() < fresh)
            return std::nullopt;
    }

    change.rows = std::move(m_rows);
    m_rows.clear();
    for (std::size_t i = first; i < now.size(); ++i) {
        change.fresh.push_back(now[i].delta);
        learn(now[i]);
    }
    change.ahead = m_ahead = static_cast<std::uint32_t>(m_document.future().size());
    change.look = m_look = m_document.look();
    m_history = now;
    m_seen.clear();
    return change;
}

} // namespace espalier

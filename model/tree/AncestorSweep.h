// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Headroom.h"
#include "model/base/Ids.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace espalier {

/// Carries differences of sums over subtrees down to the base: each internode with a difference is visited
/// once, children before parents, and passes its difference on to its parent. A parent's id is smaller than
/// its children's, so this is one pass down a bit set. Its cost is the number of visited internodes plus a
/// 4096th of the ids.
///
/// Differences are stored only where there are any, in pages of 64 ids. A page is used again as soon as the
/// pass has left its ids, so a sweep along a few paths needs a few pages, whatever the size of the tree.
///
/// @tparam Difference a value with operators += and ==; Difference{} is none
template <class Difference>
class AncestorSweep {
public:
    /// Adds @p difference to that of internode @p id.
    void add(InternodeId id, const Difference& difference)
    {
        const std::size_t word = id / kPageSize;
        if (word >= m_marks.size()) {
            resizeColumn(m_marks, word + 1, std::uint64_t{0});
            resizeColumn(m_pageOf, word + 1, kNoPage);
            m_used.resize(word / 64 + 1, 0);
        }
        m_end = std::max(m_end, word + 1);
        entry(id) += difference;
    }

    /// Removes the differences of the ids from @p size on.
    void truncate(InternodeId size)
    {
        const std::size_t first = size / kPageSize;
        for (std::size_t word = first; word < m_end; ++word) {
            const std::size_t kept = word == first ? size % kPageSize : 0;
            for (std::uint64_t gone = m_marks[word] >> kept << kept; gone != 0; gone &= gone - 1)
                m_pages[m_pageOf[word]][static_cast<std::size_t>(std::countr_zero(gone))] = {};
            m_marks[word] &= (std::uint64_t{1} << kept) - 1;
            if (m_marks[word] == 0 && m_pageOf[word] != kNoPage)
                release(word);
        }
        m_end = std::min(m_end, (std::size_t{size} + kPageSize - 1) / kPageSize);
    }

    /// Calls @p visit(id, difference) for each internode whose difference is not none, from the highest id
    /// down, and removes the differences. @p parents has the parent of each id; kNoInternode for a root.
    template <class Visit>
    void run(std::span<const InternodeId> parents, Visit&& visit)
    {
        for (std::size_t block = (m_end + 63) / 64; block-- > 0;) {
            while (m_used[block] != 0) {
                const std::size_t word = block * 64 + highest(m_used[block]);
                // Parents can be in the same word, so its page is released only when all of it is done.
                while (m_marks[word] != 0) {
                    const std::size_t bit = highest(m_marks[word]);
                    m_marks[word] &= ~(std::uint64_t{1} << bit);
                    const Difference difference = std::exchange(m_pages[m_pageOf[word]][bit], Difference{});
                    if (difference == Difference{})
                        continue;
                    const auto id = static_cast<InternodeId>(word * kPageSize + bit);
                    visit(id, difference);
                    if (const InternodeId parent = parents[id]; parent != kNoInternode)
                        entry(parent) += difference;
                }
                release(word);
            }
        }
        m_end = 0;
        if (m_pages.size() > kMostPagesKept) {
            freeList(m_pages);
            freeList(m_unused);
        }
    }

    /// Memory in bytes.
    std::size_t bytes() const
    {
        return (m_marks.capacity() + m_used.capacity()) * sizeof(std::uint64_t) +
               m_pages.capacity() * sizeof(Page) +
               (m_pageOf.capacity() + m_unused.capacity()) * sizeof(std::uint32_t);
    }

private:
    static constexpr std::size_t kPageSize = 64;
    /// 64 KB of differences of 8 bytes. After a sweep that needed more, all pages are freed.
    static constexpr std::size_t kMostPagesKept = 128;
    static constexpr std::uint32_t kNoPage = ~0U;

    using Page = std::array<Difference, kPageSize>;

    static std::size_t highest(std::uint64_t bits)
    {
        return static_cast<std::size_t>(63 - std::countl_zero(bits));
    }

    /// Marks @p id and returns its difference.
    Difference& entry(InternodeId id)
    {
        const std::size_t word = id / kPageSize;
        if (m_pageOf[word] == kNoPage) {
            m_pageOf[word] = unusedPage();
            m_used[word / 64] |= std::uint64_t{1} << (word % 64);
        }
        m_marks[word] |= std::uint64_t{1} << (id % kPageSize);
        return m_pages[m_pageOf[word]][id % kPageSize];
    }

    /// A page without differences.
    std::uint32_t unusedPage()
    {
        if (m_unused.empty()) {
            m_pages.emplace_back();
            return static_cast<std::uint32_t>(m_pages.size() - 1);
        }
        const std::uint32_t page = m_unused.back();
        m_unused.pop_back();
        return page;
    }

    void release(std::size_t word)
    {
        m_unused.push_back(std::exchange(m_pageOf[word], kNoPage));
        m_used[word / 64] &= ~(std::uint64_t{1} << (word % 64));
    }

    // A word is 64 consecutive ids.
    std::vector<std::uint64_t> m_marks;  ///< By word: bit set of the ids that may have a difference
    std::vector<std::uint32_t> m_pageOf; ///< By word
    std::vector<std::uint64_t> m_used;   ///< Bit set of the words that have a page
    std::size_t m_end = 0;               ///< Words from here on have no page
    std::vector<Page> m_pages;
    std::vector<std::uint32_t> m_unused; ///< Pages that no word has; all their differences are none
};

} // namespace espalier

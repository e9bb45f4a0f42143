// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// Visits marked internodes and all their ancestors, each once, children before parents. A parent's id is
/// smaller than its children's, so this is one pass down a bit set. Its cost is the number of ancestors plus
/// a 64th of the ids.
class AncestorSweep {
public:
    void mark(InternodeId id)
    {
        const std::size_t word = id / 64;
        if (word >= m_words.size())
            m_words.resize(word + word / 2 + 1, 0);
        m_words[word] |= std::uint64_t{1} << (id % 64);
        m_end = std::max(m_end, word + 1);
    }

    /// Removes the marks of the ids from @p size on.
    void truncate(InternodeId size)
    {
        const std::size_t words = (std::size_t{size} + 63) / 64;
        if (m_end >= words && size % 64 != 0)
            m_words[words - 1] &= (std::uint64_t{1} << (size % 64)) - 1;
        for (std::size_t word = words; word < m_end; ++word)
            m_words[word] = 0;
        m_end = std::min(m_end, words);
    }

    /// Calls @p visit(id, parent) from the highest id down and removes the marks. @p parents has the parent
    /// of each id; kNoInternode for a root.
    template <class Visit>
    void run(std::span<const InternodeId> parents, Visit&& visit)
    {
        for (std::size_t word = m_end; word-- > 0;) {
            while (m_words[word] != 0) {
                const int bit = 63 - std::countl_zero(m_words[word]);
                m_words[word] &= ~(std::uint64_t{1} << bit);
                const auto id = static_cast<InternodeId>(word * 64 + static_cast<std::size_t>(bit));
                const InternodeId parent = parents[id];
                visit(id, parent);
                if (parent != kNoInternode)
                    m_words[parent / 64] |= std::uint64_t{1} << (parent % 64);
            }
        }
        m_end = 0;
    }

private:
    std::vector<std::uint64_t> m_words;
    std::size_t m_end = 0;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeTables.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace espalier {

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

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Headroom.h"
#include "model/base/Ids.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace espalier {

/// A column by id that is cleared at nearly no cost: an entry counts only if it was set since the last
/// clear(). One clear() in 255 goes through the column.
template <class T>
class StampedColumn {
public:
    /// Removes all entries and makes room for ids below @p size.
    void clear(std::size_t size)
    {
        if (++m_epoch == 0) {
            std::ranges::fill(m_stamps, std::uint8_t{0});
            m_epoch = 1;
        }
        if (size > m_stamps.size()) {
            resizeColumn(m_stamps, size, std::uint8_t{0});
            resizeColumn(m_values, size);
        }
    }
    /// Precondition of the functions below: the id is below the size of the last clear().
    bool has(InternodeId id) const { return m_stamps[id] == m_epoch; }
    const T& operator[](InternodeId id) const { return m_values[id]; }
    void set(InternodeId id, const T& value)
    {
        m_stamps[id] = m_epoch;
        m_values[id] = value;
    }
    /// Sets the entry if there is none; returns whether it did.
    bool setOnce(InternodeId id, const T& value)
    {
        if (has(id))
            return false;
        set(id, value);
        return true;
    }

private:
    std::vector<std::uint8_t> m_stamps; ///< The value of m_epoch when the entry was set; 0 for never
    std::vector<T> m_values;
    std::uint8_t m_epoch = 0;
};

} // namespace espalier

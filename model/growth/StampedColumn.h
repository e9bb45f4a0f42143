// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"

#include <vector>

namespace espalier {

/// A column by id that is cleared in constant time: an entry counts only if it was set since the last
/// clear().
template <class T>
class StampedColumn {
public:
    /// Removes all entries and makes room for ids below @p size.
    void clear(std::size_t size)
    {
        ++m_epoch;
        if (size > m_stamps.size()) {
            m_stamps.resize(size + size / 2, 0);
            m_values.resize(size + size / 2);
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
    std::vector<std::uint32_t> m_stamps;
    std::vector<T> m_values;
    std::uint32_t m_epoch = 0;
};

} // namespace espalier

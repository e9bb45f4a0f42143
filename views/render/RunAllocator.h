// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace espalier {

/// A run of elements in a large array.
struct Run {
    std::uint32_t first = 0;
    std::uint32_t capacity = 0;
    bool operator==(const Run&) const = default;
};

/// Allocates and frees runs of one large array. There are four capacities in each octave, so that a run that
/// grows a little stays at its place, and a freed run fits again; at most a fifth of a run is slack, except
/// for runs of less than 16.
class RunAllocator {
public:
    /// The capacity for @p count elements, at least @p count; 0 for 0.
    static constexpr std::uint32_t capacityFor(std::uint32_t count)
    {
        const std::uint32_t granule = granuleOf(count);
        return (count + granule - 1) / granule * granule;
    }

    /// Allocates a run with room for @p count elements; a run without an address if that is 0.
    Run allocate(std::uint32_t count)
    {
        const std::uint32_t capacity = capacityFor(count);
        if (capacity == 0)
            return {};
        std::vector<std::uint32_t>& free = freeRuns(capacity);
        if (free.empty()) {
            const Run run{m_end, capacity};
            m_end += capacity;
            return run;
        }
        const Run run{free.back(), capacity};
        free.pop_back();
        return run;
    }

    void release(const Run& run)
    {
        if (run.capacity > 0)
            freeRuns(run.capacity).push_back(run.first);
    }

    /// Number of elements that the array must have.
    std::uint32_t end() const { return m_end; }

private:
    static constexpr std::uint32_t granuleOf(std::uint32_t count)
    {
        return count <= 16 ? 4 : std::bit_floor(count - 1) / 4;
    }

    std::vector<std::uint32_t>& freeRuns(std::uint32_t capacity)
    {
        // Each of the capacities in one octave, (4, 5, 6, 7 or 8) granules, has its own list.
        const std::uint32_t granule = granuleOf(capacity);
        const std::size_t list = 5 * static_cast<std::size_t>(std::bit_width(granule)) + capacity / granule;
        if (list >= m_free.size())
            m_free.resize(list + 1);
        return m_free[list];
    }

    std::vector<std::vector<std::uint32_t>> m_free;
    std::uint32_t m_end = 0;
};

} // namespace espalier

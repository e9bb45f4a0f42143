// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace espalier::test {

/// A memory that becomes short: while this object lives, allocations of more than @p size bytes are counted,
/// and one of them fails. It replaces malloc() in the whole program. Only one object can exist at a time.
class FaultyMemory {
public:
    static constexpr int kNever = -1;

    /// @p good: how many large allocations succeed before the one that fails.
    FaultyMemory(int good, std::size_t size);
    ~FaultyMemory();
    FaultyMemory(const FaultyMemory&) = delete;
    FaultyMemory& operator=(const FaultyMemory&) = delete;

    /// How many large allocations there were so far.
    int calls() const;
};

} // namespace espalier::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace espalier {

/// Asks the system to use large pages for a block of several megabytes that is still untouched: a block of 50
/// MB then costs 25 page faults in place of 12,000, which would take longer than to fill it. Without effect
/// where the system has none.
inline void wantLargePages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
    constexpr std::uintptr_t kPage = std::uintptr_t{2} << 20U;
    const auto begin = (reinterpret_cast<std::uintptr_t>(block) + kPage - 1) / kPage * kPage;
    const auto end = (reinterpret_cast<std::uintptr_t>(block) + bytes) / kPage * kPage;
    if (begin < end)
        madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

} // namespace espalier

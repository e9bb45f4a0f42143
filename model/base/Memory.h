// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace espalier {

/// Lets this process keep up to 64 MB that it has freed, for the next use, and take blocks below 32 MB from
/// there. Otherwise glibc returns large blocks to the system at once, and each growth step, which needs the
/// same few megabytes again, spends up to a quarter of its time on new pages. To be called once, before other
/// threads start. Does nothing with other C libraries.
void keepFreedMemory();

/// Blocks from this size on, in bytes, come in large pages where the system has them: a block of 50 MB then
/// costs 25 page faults in place of 12,000, which would take longer than to fill it.
inline constexpr std::size_t kLargeBlock = std::size_t{4} << 20U;
/// Returns a block of at least kLargeBlock bytes; throws std::bad_alloc if there is none.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* block) noexcept;

} // namespace espalier

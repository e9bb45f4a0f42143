// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace espalier {

/// Memory that this process can still get without taking it from others, bytes: what the system has
/// available, less if a limit of the process or of its container is nearer. The greatest number if that is
/// not known.
std::uint64_t availableMemory();

/// Lets this process keep up to 64 MB that it has freed, for the next use, and take blocks below 32 MB from
/// there. Otherwise glibc returns large blocks to the system at once, and each growth step, which needs the
/// same few megabytes again, spends up to a quarter of its time on new pages. To be called once, before other
/// threads start. Does nothing with other C libraries.
void keepFreedMemory();

} // namespace espalier

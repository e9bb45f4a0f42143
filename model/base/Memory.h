// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace espalier {

/// Lets this process keep up to 64 MB that it has freed, for the next use, and take blocks below 32 MB from
/// there. Otherwise glibc returns large blocks to the system at once, and each growth step, which needs the
/// same few megabytes again, spends up to a quarter of its time on new pages. To be called once, before other
/// threads start. Does nothing with other C libraries.
void keepFreedMemory();

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace espalier::test {

/// Kills a process before, in and after each call that changes files, while it does one of the Jobs. @p all:
/// at every call; otherwise at a few of each kind. Returns what went wrong, or nothing.
///
/// The processes are forks of this one, which may have no other thread.
QString tryDeaths(bool all);

} // namespace espalier::test

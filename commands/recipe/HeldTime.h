// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace espalier {

/// The longest time that an operation holds a branch, s.
inline constexpr double kMostHeldSeconds = 600.0;

} // namespace espalier

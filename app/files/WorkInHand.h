// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace espalier {

/// A change of the document that is under way and no undo step yet: a gesture, or growth. The code that opens
/// and saves files learns of it only through these functions; their defaults mean that nothing is under way.
struct WorkInHand {
    std::function<bool()> isUnderWay = [] { return false; };
    /// Ends the work under way and keeps it, as undo steps.
    std::function<void()> finish = [] {};
};

} // namespace espalier

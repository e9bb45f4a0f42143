// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace espalier {

/// What is changing the document just now and is no undo step yet: a gesture, or growth. This is the only
/// place where what is done with files asks for it; until it is told of any, there is none.
struct WorkInHand {
    std::function<bool()> isUnderWay = [] { return false; };
    /// Ends it and keeps it, as undo steps.
    std::function<void()> finish = [] {};
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"

#include <cstddef>

namespace espalier {

/// The deltas of one edit, or of several in a row, in a journal: [first, end).
struct JournalEdit {
    /// The edit that begins at @p first, as far as @p journal has it; a delta without a record is an edit of
    /// its own. Precondition: first < journal.size().
    static JournalEdit at(const Journal& journal, std::size_t first);

    std::size_t first;
    std::size_t end;
};

} // namespace espalier

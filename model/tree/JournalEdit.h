// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"

#include <cstddef>

namespace espalier {

/// The deltas of one edit, or of several in a row, in a journal: [first, end). None if both are equal.
struct JournalEdit {
    /// The edit that begins at @p first, as far as @p journal has it. Deltas without a record in a row count
    /// as one, and with an edit before them whose record knows nothing. Precondition: first < journal.size().
    static JournalEdit at(const Journal& journal, std::size_t first);

    std::size_t first;
    std::size_t end;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/JournalEdit.h"

namespace espalier {

JournalEdit JournalEdit::at(const Journal& journal, std::size_t first)
{
    const std::size_t deltas = journal[first]->record ? journal[first]->record->deltas : 1;
    std::size_t end = first + 1;
    while (end < journal.size() && end - first < deltas && !journal[end]->record)
        ++end;
    return {first, end};
}

} // namespace espalier

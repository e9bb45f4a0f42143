// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/JournalEdit.h"

namespace espalier {

JournalEdit JournalEdit::at(const Journal& journal, std::size_t first)
{
    const EditRecord* record = journal[first]->record.get();
    const bool isKnown = record && !record->operation.isEmpty();
    std::size_t end = first + 1;
    while (end < journal.size() && !journal[end]->record && (!isKnown || end - first < record->deltas))
        ++end;
    return {first, end};
}

} // namespace espalier

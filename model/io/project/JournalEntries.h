// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/ZipArchive.h"
#include "model/tree/Tree.h"

namespace espalier {

/// Adds a journal to a project's archive, by the lists of columns in TreeTables.h. Entries journal/<number>
/// have a row a delta. For each kind of change that occurs, journal/<kind>.count has a row a delta, and the
/// other entries of the kind have the changes of all deltas, in the journal's order. RecordEntries.h says how
/// the records are held. Precondition: each
/// delta's births follow those of the one before.
void addJournal(ZipWriter& archive, const Journal& journal);

/// The sizes of a tree's tables after the last delta of a journal.
struct JournalBounds {
    std::uint32_t internodes = 0;
    std::uint32_t leaves = 0;
    std::uint32_t lassos = 0;

    static JournalBounds of(const TreeContent& content);
};

/// Reads @p deltas deltas that lead to a tree of those sizes. Before a delta is made, it
/// checks that each delta changes something, that counts add up and that no delta changes or adds more rows
/// than there are; checkJournal() checks the values.
Result<Journal> readJournal(const ZipReader& archive, std::uint32_t deltas, const JournalBounds& bounds);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/ZipArchive.h"
#include "model/tree/TreeDelta.h"

namespace espalier {

/// Adds what made the edits of a journal (EditRecord) to a project's archive, unless no delta has a record:
/// journal/records.deltas has a row a delta, which is 0 where no edit begins; journal/records.size has a row
/// an edit, the bytes of its operation; journal/records.json has the operations, one after another. An
/// operation that finds no room within projectLimits::kRecordBytes is left out: it is not known then.
void addRecords(ZipWriter& archive, const Journal& journal);

/// Gives @p journal the records that the archive has; none if the file is older than records. An Error for
/// entries that do not fit together, and for an operation that is not a JSON object. What the operations say
/// is not looked at.
Result<void> readRecords(const ZipReader& archive, Journal& journal);

} // namespace espalier

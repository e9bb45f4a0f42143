// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace espalier {

struct EditRecord;

/// What the user calls an edit of a journal, by the recipe's operation in @p record: "Brush Stroke", "Prune".
/// Unlike the texts of the undo stack it is known of a tree from a file, too. Empty if the operation is
/// unknown.
QString titleOfEdit(const EditRecord& record);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/JournalEdit.h"
#include "model/tree/Tree.h"

#include <QString>

#include <span>

namespace espalier {

/// What the user calls an edit of a journal, by the recipe's operation in @p record: "Brush Stroke", "Prune".
/// Unlike the texts of the undo stack it is known of a tree from a file, too. Empty if the operation is
/// unknown.
QString titleOfEdit(const EditRecord& record);

/// The same for an undo step, with what the deltas of @p edit tell of it: "Brush Stroke, 34 branches". Edits
/// of which nothing is known are "Earlier Steps". @p tree has all deltas of @p history applied.
QString titleOfStep(const Tree& tree, const Journal& history, const JournalEdit& edit);

/// Of a stroke of the brush that has made @p deltas; those must be applied to @p tree.
QString titleOfBrushStroke(const Tree& tree, std::span<const std::shared_ptr<TreeDelta>> deltas);
/// Of growth by @p steps, or of a travel to another moment if that is 0.
QString titleOfGrowth(int steps);

} // namespace espalier

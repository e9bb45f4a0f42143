// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/TreeFigure.h"
#include "model/base/Error.h"
#include "model/document/TreeDocument.h"

#include <cstdint>

namespace espalier {

/// Gives the seedling's tree the figure of two strokes (reproduced()), as one undo step. The trunk's stroke
/// is smoothed (a pixel being a thousandth of the diagonal of both strokes). Returns the number of branches
/// that begin outside the silhouette and are shortened for that. Fails (Kind::Input), and changes nothing, if
/// the trunk is a dot or a loop, or as reproduced() does.
Result<std::uint32_t> reproduceTree(TreeDocument& document, TreeFigure figure);

} // namespace espalier

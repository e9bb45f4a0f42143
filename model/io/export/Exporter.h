// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/export/ExportFormats.h"

#include <functional>

namespace espalier {

/// Told the share that is done, 0...1; false as an answer cancels.
using Progress = std::function<bool(double)>;

/// Writes the living tree to a file, in the format that its ending names (see exportFormats()).
///
/// Textures of formats that have them outside are called after the file, such as oak_bark.png,
/// oak_bark_normal.png; they never replace a file that is not an earlier export's (see ExportFiles). Nodes
/// and materials are called after @p name (see ExportScene). Files are replaced whole once all have been
/// written: an error or a cancellation leaves everything as it was. Takes seconds for large trees; may run on
/// any thread while the tree does not change.
Result<void> exportTree(const Tree& tree, const TreeIndex& index, const QString& name,
                        const QString& fileName, const ExportOptions& options = {},
                        const Progress& progress = {});

} // namespace espalier

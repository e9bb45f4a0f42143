// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/export/ExportFiles.h"
#include "model/io/export/ExportFormats.h"

#include <functional>

namespace espalier {

/// Called with the finished share, 0...1; returns false to cancel.
using Progress = std::function<bool(double)>;

/// Writes the living tree to a file, in the format that its ending names (see exportFormats()).
///
/// Formats with textures outside the model name them after the file, such as oak_bark.png,
/// oak_bark_normal.png; they never replace a file that is not an earlier export's (see ExportFiles). Nodes
/// and materials are named after @p name (see ExportScene). The files are replaced once all have been
/// written: an error or a cancellation leaves the old files as they were. Takes seconds for large trees; can
/// be called on any thread while the tree does not change.
Result<void> exportTree(const Tree& tree, const TreeIndex& index, const QString& name,
                        const QString& fileName, const ExportOptions& options = {},
                        const Progress& progress = {});

/// The files of such an export, whole but not in their places yet. @p others: see ExportFiles.
Result<ExportFiles> prepareExport(const Tree& tree, const TreeIndex& index, const QString& name,
                                  const QString& fileName, const ExportOptions& options = {},
                                  const Progress& progress = {}, const QStringList& others = {});

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/export/ExportScene.h"

#include <functional>

namespace espalier {

/// Told the share that is done, 0...1; false as an answer cancels.
using Progress = std::function<bool(double)>;

/// Endings of the formats that exportTree knows, without a dot: glb, fbx, obj, csv.
QStringList exportSuffixes();

/// Writes the living tree to a file, in the format that its ending names:
///
/// - .glb: binary glTF, textures inside;
/// - .fbx: binary FBX, textures beside it;
/// - .obj: Wavefront OBJ, materials (.mtl) and textures beside it;
/// - .csv: the skeleton, see SkeletonWriter.
///
/// Textures are called after the file, such as oak_bark.png, oak_bark_normal.png, oak_bark_roughness.png;
/// nodes and materials after
/// @p name (see ExportScene). Files are replaced whole once all have been written: an error or a cancellation
/// leaves everything as it was. Takes seconds for large trees; may run on any thread while nobody changes the
/// tree.
Result<void> exportTree(const Tree& tree, const TreeIndex& index, const QString& name,
                        const QString& fileName, const ExportOptions& options = {},
                        const Progress& progress = {});

} // namespace espalier

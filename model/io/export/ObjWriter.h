// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/AssimpExport.h"

#include <QIODevice>

namespace espalier {

/// Writes the scene as Wavefront OBJ, an object a mesh. Written here, for Assimp takes some seven seconds for
/// a million vertices, more than ten times as long.
bool writeObj(QIODevice& device, const ExportScene& scene, const QString& materialFileName);
/// The materials that belong to it.
QByteArray toMtl(const ExportScene& scene, const TextureFileName& textureFileName);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFiles.h"
#include "model/io/export/ExportScene.h"

namespace espalier {

/// What follows the stem in the file name of a texture: "_bark_normal.png".
QString textureEnding(const ExportTexture& texture);

/// Endings of all textures of a scene, for formats that keep them in files of their own.
QStringList textureEndings(const ExportScene& scene);

/// Adds all textures of a scene; the names must have been chosen.
Result<void> addTextures(const ExportScene& scene, ExportFiles& files);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFiles.h"
#include "model/io/export/ExportScene.h"

namespace espalier {

/// The part of a texture's file name that follows the stem: "_bark_normal.png".
QString textureEnding(const ExportTexture& texture);

/// Endings of all textures of a scene, for formats that keep textures in separate files.
QStringList textureEndings(const ExportScene& scene);

/// Adds all textures of a scene; the names must have been chosen.
Result<void> addTextures(const ExportScene& scene, ExportFiles& files);

} // namespace espalier

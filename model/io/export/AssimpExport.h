// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/export/ExportScene.h"

#include <QByteArray>

#include <functional>

namespace espalier {

/// Where a texture is to be found: a file name beside the exported file.
using TextureFileName = std::function<QString(const ExportTexture&)>;

/// The scene as binary glTF, its textures inside.
Result<QByteArray> toGlb(const ExportScene& scene);
/// The scene as binary FBX, its textures in files of their own.
Result<QByteArray> toFbx(const ExportScene& scene, const TextureFileName& textureFileName);

} // namespace espalier

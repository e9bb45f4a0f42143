// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/ImageAsset.h"

namespace espalier {

namespace imageLimits {
inline constexpr qsizetype kBytes = 64 << 20; ///< Of the file
inline constexpr int kEdge = 8192;            ///< px
inline constexpr int kLeastEdge = 4;          ///< px
} // namespace imageLimits

/// Reads an image without trusting it: PNG or JPEG, within the limits. What it is comes from its bytes,
/// whatever the file is called. The error is one sentence that begins with @p name. Large images take a
/// second.
Result<ImageAsset> readImage(const QByteArray& file, const QString& name);
/// The same but for the last step: does not unpack it, so it may still turn out to be broken.
Result<ImageAsset> glanceAtImage(const QByteArray& file, const QString& name);
/// readImage() from a file; @p name instead of the file's own if it is not empty.
Result<ImageAsset> readImageFile(const QString& fileName, const QString& name = {});

/// The other images of a material, which lie beside that of its colours and are called alike.
struct MaterialFiles {
    QString normal;    ///< Green up; empty if there is none
    QString roughness; ///< Empty if there is none
};

/// Looks beside "bark_colour.png" (or bark_albedo, bark_basecolor, bark_diffuse, bark) for bark_normal,
/// bark_normalgl, bark_nor_gl and so on, and for bark_roughness, bark_rough, whatever the case of the
/// letters.
MaterialFiles findMaterialFiles(const QString& fileName);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/ImageAsset.h"

namespace espalier {

namespace imageLimits {
inline constexpr qsizetype kBytes = 64 << 20;         ///< Size of the file
inline constexpr qsizetype kPictureBytes = 256 << 20; ///< Size of a file that readPictureFile() reads
inline constexpr int kEdge = 8192;                    ///< px
inline constexpr int kLeastEdge = 4;                  ///< px
} // namespace imageLimits

/// Reads an image without trusting it: PNG or JPEG, within the limits. The format is found from the bytes,
/// not from the file's name. The error is one sentence that begins with @p name. Large images take a second.
Result<ImageAsset> readImage(const QByteArray& file, const QString& name);
/// Like readImage(), but does not unpack the pixels, so the image can still turn out to be broken.
Result<ImageAsset> glanceAtImage(const QByteArray& file, const QString& name);
/// readImage() from a file; @p name instead of the file's own if it is not empty.
Result<ImageAsset> readImageFile(const QString& fileName, const QString& name = {});

/// Reads a picture of any format that Qt reads: one that is not readImage()'s, or larger than its limits, is
/// packed anew, at most ImageAsset::kLargestEdge px along an edge. Takes a second for large ones.
Result<ImageAsset> readPictureFile(const QString& fileName);

/// The other images of a material, which lie beside the image of its colours and have similar names.
struct MaterialFiles {
    QString normal;    ///< Green up; empty if there is none
    QString roughness; ///< Empty if there is none
};

/// Looks beside "bark_colour.png" (or bark_albedo, bark_basecolor, bark_diffuse, bark) for bark_normal,
/// bark_normalgl, bark_nor_gl and so on, and for bark_roughness, bark_rough. Upper and lower case count as
/// equal.
MaterialFiles findMaterialFiles(const QString& fileName);

} // namespace espalier

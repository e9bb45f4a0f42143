// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

#include <QImage>

namespace espalier {

/// Hue of the leaf textures, rad on the colour wheel: a green. LeafInstance::hueShift is the difference
/// between a leaf's own hue and this one.
inline constexpr double kLeafTextureHue = radians(98);

/// The images of a material, all of one size.
struct SurfaceTextures {
    QImage colour; ///< sRGB; Format_RGB888, or Format_RGBA8888 (not premultiplied) where alpha is coverage
    /// Tangent space: red along u, green up in the image, blue out of the surface (OpenGL's convention);
    /// Format_RGB888.
    QImage normal;
    QImage roughness; ///< 0 a mirror, 255 chalk (as in glTF); Format_Grayscale8
};

/// Bark, made from noise: square, of @p size pixels (a power of two, 16...8192), repeating in both directions
/// without a seam. The tree stands upright in the image. Without alpha. The same arguments give the same
/// bytes; each call makes the images again, so keep the result.
SurfaceTextures barkTextures(BarkKind kind, int size);
/// The colour image of that bark, in about half the time.
QImage barkAlbedo(BarkKind kind, int size);

/// A leaf that fills the card of its shape (see LeafCard.h): petiole at the middle of the lower edge, tip at
/// the upper one; for needles a twig full of them. Alpha is coverage; the colour continues beyond the edge,
/// so that scaling the image down gives no dark seam. Normal and roughness are those of the upper face. @p
/// hue, rad, is the hue of the green.
SurfaceTextures leafTextures(LeafShape shape, int size, double hue = kLeafTextureHue);
/// The colour image of that leaf.
QImage leafAlbedo(LeafShape shape, int size, double hue = kLeafTextureHue);
/// Multiplies the saturation (as in HSV) of a leaf's colours by @p factor, 0 or more; alpha stays.
void saturateLeaf(QImage& albedo, double factor);

} // namespace espalier

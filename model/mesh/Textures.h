// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

#include <QImage>

namespace espalier {

/// Hue of the leaf textures, rad on the colour wheel: a green from which LeafInstance::hueShift leads to a
/// leaf's own.
inline constexpr double kLeafTextureHue = radians(98);

/// Bark, made by noise: square, of @p size pixels (a power of two, 16...8192), repeating in both directions
/// without a seam. The tree stands upright in the image. Without alpha (Format_RGB888); colours are sRGB. The
/// same bytes each time; made anew on each call, so keep what you get.
QImage barkAlbedo(BarkKind kind, int size);
/// The normal map that belongs to it: red along u, green up in the image, blue out of the bark (OpenGL's
/// convention).
QImage barkNormal(BarkKind kind, int size);

/// A leaf that fills the card of its shape (see LeafCard.h): petiole at the middle of the lower edge, tip at
/// the upper one; for needles a twig full of them. Alpha is coverage (Format_RGBA8888, not premultiplied);
/// the colour goes on beyond the edge, so that scaling it down draws no dark seam. @p hue, rad, is that of
/// the green.
QImage leafAlbedo(LeafShape shape, int size, double hue = kLeafTextureHue);
/// Multiplies the saturation (as in HSV) of such a leaf's colours, a @p factor of 0 or more; alpha stays.
void saturateLeaf(QImage& albedo, double factor);
/// The normal map of a leaf's upper face, without alpha (Format_RGB888).
QImage leafNormal(LeafShape shape, int size);

} // namespace espalier

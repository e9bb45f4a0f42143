// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/texture/Textures.h"

#include <optional>

namespace espalier {

/// What of an image is a leaf, as it fills its card: petiole at the middle of the lower edge, no empty
/// margin; at most @p size pixels along an edge, Format_RGBA8888. Alpha is coverage; where the image has
/// none, its plain background is taken out, from the edges inward. The colour goes on beyond the leaf's edge.
/// Nothing if there is neither alpha nor a plain background, or nothing would be left.
std::optional<QImage> cutLeaf(const ImageAsset& image, int size);
/// Width / length of that leaf, within the limits of LeafParameters::aspect.
std::optional<double> ownLeafAspect(const ImageAsset& image);
/// A sentence for a person about an image that cutLeaf() finds no leaf in.
QString noLeafIn(const ImageAsset& image);

/// Leaves that look as the image does: with its aspect and its own colours.
void adoptImage(LeafParameters& leaves, const ImageAsset& image, double aspect);

/// The textures that the parameters name, drawn (see Textures.h) or of the person's own images, of @p size
/// pixels or fewer. Of an image of one's own, what it does not say follows from its light and dark: what is
/// dark lies deep, and is duller. Where an image is broken, the drawn one takes its place. Bark is square and
/// repeats; an image that does not fit its own opposite edge is faded into it.
SurfaceTextures barkTextures(const BarkParameters& bark, int size);
/// In the colours of the texture, whatever the parameters say of hue, saturation and brightness.
SurfaceTextures leafTextures(const LeafParameters& leaves, int size);

/// What the linear colour of a texture is to be multiplied by so that its hue turns by @p angle (rad), as the
/// viewport does: exact for kLeafTextureHue, and for other colours of that kind.
std::array<double, 3> hueFactors(double angle);

} // namespace espalier

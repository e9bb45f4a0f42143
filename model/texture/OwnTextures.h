// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/texture/Textures.h"

#include <optional>

namespace espalier {

/// Width / length of the leaf that cutLeaf() finds, within the limits of LeafParameters::aspect.
std::optional<double> ownLeafAspect(const ImageAsset& image);
/// A sentence for the user about an image in which cutLeaf() finds no leaf.
QString noLeafIn(const ImageAsset& image);

/// Sets the parameters so that leaves look like the image: with its aspect and its own colours.
void adoptImage(LeafParameters& leaves, const ImageAsset& image, double aspect);

/// The textures for the bark parameters, drawn (see Textures.h) or made from the user's images, of @p size
/// pixels or fewer. If there is only a colour image, normals and roughness follow from its brightness: dark
/// pixels lie deep and are rougher. The drawn texture replaces a broken image. Bark is square and repeats; if
/// opposite edges of an image do not match, one is faded into the other.
SurfaceTextures barkTextures(const BarkParameters& bark, int size);
/// The textures for the leaf parameters, in the texture's own colours: hue, saturation and brightness of the
/// parameters are not applied.
SurfaceTextures leafTextures(const LeafParameters& leaves, int size);

/// The factors for the linear colour of a texture that turn its hue by @p angle (rad), as the viewport does:
/// exact for kLeafTextureHue, approximate for similar colours.
std::array<double, 3> hueFactors(double angle);

} // namespace espalier

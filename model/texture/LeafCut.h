// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/ImageAsset.h"

#include <optional>

namespace espalier {

/// Cuts the leaf out of an image so that it fills its card: petiole at the middle of the lower edge, no empty
/// margin; at most @p size pixels along an edge, Format_RGBA8888. Alpha is coverage; in an image without
/// alpha, the plain background is removed from the edges inward. The colour continues beyond the leaf's edge.
/// Returns nothing if the image has neither alpha nor a plain background, or if no leaf is left.
std::optional<QImage> cutLeaf(const ImageAsset& image, int size);

} // namespace espalier

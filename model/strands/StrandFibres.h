// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandLayouts.h"

#include <array>
#include <vector>

namespace espalier {

/// An end of a piece of a fibre, in the form that the graphics card gets: 16 bytes without padding.
struct FibreVertex {
    std::array<float, 3> position;      ///< m
    std::array<std::uint8_t, 4> colour; ///< Red, green, blue, 255; sRGB
};
static_assert(sizeof(FibreVertex) == 16);

/// The most pieces of fibres that are made by default: they are drawn in a few milliseconds.
inline constexpr std::size_t kMostFibrePieces = 200000;

/// Strands as lines along their curves (StrandCurves): two vertices for each piece. The strands of one limb
/// have one hue, and those of its branches similar ones; they stay the same while the tree grows and is
/// edited. Strands inside thick wood are darker. Of a tree whose strands would need more than @p most pieces,
/// only every second, third and so on is made.
/// @param tree,index those of @p layouts
std::vector<FibreVertex> strandFibres(const StrandLayouts& layouts, const Tree& tree, const TreeIndex& index,
                                      std::size_t most = kMostFibrePieces);

} // namespace espalier

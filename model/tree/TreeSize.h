// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

namespace espalier {

/// How large a new tree shall become.
enum class TreeSize : int { Bonsai, Shrub, StreetTree, ForestTree };
inline constexpr int kTreeSizeCount = 4;

/// What a new tree of a size begins with, in m.
struct TreeSizePreset {
    const char* key;        ///< Stable: it is in the settings
    double height;          ///< That such a tree reaches
    double viewHeight;      ///< Of the world that shows from top to bottom, a quarter of it below ground
    double brushRadius;     ///< Of a brush for its crown
    double internodeLength; ///< GrowthParameters::internodeLength; vigour grows in proportion
    double tipDiameter;     ///< WidthParameters::tipDiameter
    double leafLength;      ///< LeafParameters::length
};

const TreeSizePreset& sizePreset(TreeSize size);

/// The parameters of a new tree of that size. Those of a street tree are the defaults.
TreeParameters parametersOfSize(TreeSize size);

} // namespace espalier

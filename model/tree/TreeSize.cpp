// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/TreeSize.h"

#include <array>

namespace espalier {

namespace {

constexpr std::array<TreeSizePreset, kTreeSizeCount> kPresets{{
    {"bonsai", 0.45, 0.75, 0.065, 0.012, 0.0008, 0.015},
    {"shrub", 1.8, 3.0, 0.26, 0.045, 0.0018, 0.05},
    {"streetTree", 6.0, 9.0, 0.75, 0.1, 0.003, 0.09},
    {"forestTree", 22.0, 32.0, 2.7, 0.3, 0.008, 0.16},
}};

} // namespace

const TreeSizePreset& sizePreset(TreeSize size)
{
    return kPresets[static_cast<std::size_t>(size)];
}

TreeParameters parametersOfSize(TreeSize size)
{
    TreeParameters parameters;
    const TreeSizePreset& preset = sizePreset(size);
    const double share = preset.internodeLength / parameters.growth.internodeLength;
    parameters.growth.internodeLength = preset.internodeLength;
    parameters.vigour.internodeLength *= share;
    parameters.vigour.growthRate *= share;
    parameters.widths.tipDiameter = preset.tipDiameter;
    parameters.leaves.length = preset.leafLength;
    return parameters;
}

} // namespace espalier

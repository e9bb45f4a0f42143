// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/IndexedModel.h"
#include "model/growth/VigourStep.h"

namespace espalier {

/// The vigour model (Strands 2024 §4.1, after Li et al. 2023): the light of its shoots decides how fast each
/// of them grows; growing tips inhibit the buds below them.
class VigourModel final : public IndexedModel {
public:
    std::unique_ptr<GrowthModel> fresh() const override { return std::make_unique<VigourModel>(); }

    TreeDelta growFreely(const Tree& tree, const TreeIndex& treeIndex, const GrowthStepOptions& options,
                         GrowthWorkspace& workspace) const override
    {
        return vigourStep(tree, treeIndex, space(), options, workspace);
    }
    TreeDelta growToward(const Tree& tree, const TreeIndex& treeIndex, MarkerSet& markers,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace) const override
    {
        return vigourStepToward(tree, treeIndex, space(), markers, options, workspace);
    }
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/IndexedModel.h"

namespace espalier {

/// TreeSketch's growth model (§3.2; Pałubicki 2009): buds compete for free space and light, and the vigour
/// that flows up from the base decides how many internodes each shoot adds.
class SelfOrganisingModel final : public IndexedModel {
public:
    std::unique_ptr<GrowthModel> fresh() const override { return std::make_unique<SelfOrganisingModel>(); }

    TreeDelta growFreely(const Tree& tree, const TreeIndex& treeIndex, const GrowthStepOptions& options,
                         GrowthWorkspace& workspace) const override
    {
        return autonomousStep(tree, treeIndex, index(), options, workspace);
    }
    TreeDelta growToward(const Tree& tree, const TreeIndex& treeIndex, MarkerSet& markers,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace) const override
    {
        return growthStep(tree, treeIndex, index(), markers, options, workspace);
    }
};

} // namespace espalier

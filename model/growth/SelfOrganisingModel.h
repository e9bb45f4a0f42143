// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthIndex.h"
#include "model/growth/GrowthModel.h"

namespace espalier {

/// TreeSketch's growth model (§3.2; Pałubicki 2009): buds compete for free space and light, and the vigour
/// that flows up from the base decides how many internodes each shoot adds.
class SelfOrganisingModel final : public GrowthModel {
public:
    std::unique_ptr<GrowthModel> fresh() const override { return std::make_unique<SelfOrganisingModel>(); }

    const GrowthIndex& index() const { return m_index; }

    void rebuild(const Tree& tree, const TreeIndex& index) override { m_index.rebuild(tree, index); }
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta) override
    {
        m_index.follow(tree, index, delta);
    }
    bool settleSome(const Tree& tree, const TreeIndex& index, std::size_t nodes) override
    {
        return m_index.settleSome(tree, index, nodes);
    }
    const VoxelSpace& space() const override { return m_index.space(); }
    std::size_t bytes() const override { return m_index.bytes(); }

    TreeDelta growFreely(const Tree& tree, const TreeIndex& index, const GrowthStepOptions& options,
                         GrowthWorkspace& workspace) const override
    {
        return autonomousStep(tree, index, m_index, options, workspace);
    }
    TreeDelta growToward(const Tree& tree, const TreeIndex& index, MarkerSet& markers,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace) const override
    {
        return growthStep(tree, index, m_index, markers, options, workspace);
    }

private:
    GrowthIndex m_index;
};

} // namespace espalier

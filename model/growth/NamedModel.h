// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/IndexedModel.h"

namespace espalier {

/// Grows each step by the model that the tree's parameters in force name (GrowthParameters::model). So undo,
/// travels, files and recipes change the model together with the parameters.
class NamedModel final : public IndexedModel {
public:
    std::unique_ptr<GrowthModel> fresh() const override { return std::make_unique<NamedModel>(); }

    TreeDelta growFreely(const Tree& tree, const TreeIndex& treeIndex, const GrowthStepOptions& options,
                         GrowthWorkspace& workspace) const override;
    TreeDelta growToward(const Tree& tree, const TreeIndex& treeIndex, MarkerSet& markers,
                         const GrowthStepOptions& options, GrowthWorkspace& workspace) const override;
};

} // namespace espalier

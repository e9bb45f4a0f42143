// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthIndex.h"
#include "model/growth/GrowthModel.h"

namespace espalier {

/// A growth model whose index is a GrowthIndex. The models of the program share that index, so a change of
/// the model costs nothing.
class IndexedModel : public GrowthModel {
public:
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

private:
    GrowthIndex m_index;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/WoodMesh.h"

#include "model/mesh/BranchMesher.h"
#include "model/mesh/LeafPlacer.h"
#include "model/mesh/StrandMesher.h"

namespace espalier {

ShownWood::ShownWood(const Tree& tree, const TreeIndex& index, const Widths& widths)
    : m_tree(tree), m_index(index), m_widths(widths)
{
    if (tree.parameters().wood.mesher == WoodMesherKind::Strands)
        m_layouts.emplace(tree, index, widths);
}

BranchMesh ShownWood::mesh(const WoodMeshOptions& options) const
{
    return m_layouts ? meshStrands(*m_layouts, m_tree.parameters(), options)
                     : meshBranches(m_tree, m_index, m_widths, options);
}

MeshBuffer<LeafInstance> ShownWood::leaves() const
{
    return placeLeaves(m_tree, m_index, m_widths, lines());
}

StrandLines ShownWood::lines() const
{
    return m_layouts ? strandLines(*m_layouts, m_tree.size()) : StrandLines();
}

BranchMesh meshWood(const Tree& tree, const TreeIndex& index, const Widths& widths,
                    const WoodMeshOptions& options)
{
    return ShownWood(tree, index, widths).mesh(options);
}

} // namespace espalier

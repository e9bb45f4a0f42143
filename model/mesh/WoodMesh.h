// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/BranchMesh.h"
#include "model/mesh/LeafInstance.h"
#include "model/mesh/WoodLines.h"

#include <optional>

namespace espalier {

/// The wood of a tree and what stands on it, as the tree's parameters say (WoodParameters::mesher): tubes or
/// strands.
class ShownWood {
public:
    /// All must outlive this. Arranges the strands, if there are any.
    ShownWood(const Tree& tree, const TreeIndex& index, const Widths& widths);

    BranchMesh mesh(const WoodMeshOptions& options = {}) const;
    /// The leaves, on the bark of the wood.
    MeshBuffer<LeafInstance> leaves() const;
    /// Where the wood of strands lies, by internode; empty for tubes.
    StrandLines lines() const;
    /// Null for tubes.
    const StrandLayouts* layouts() const { return m_layouts ? &*m_layouts : nullptr; }

private:
    const Tree& m_tree;
    const TreeIndex& m_index;
    const Widths& m_widths;
    std::optional<StrandLayouts> m_layouts;
};

/// Meshes the wood of a tree as its parameters say.
BranchMesh meshWood(const Tree& tree, const TreeIndex& index, const Widths& widths,
                    const WoodMeshOptions& options = {});

} // namespace espalier

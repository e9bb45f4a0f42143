// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandLayouts.h"

#include <span>
#include <vector>

namespace espalier {

/// The wood of one internode that leaves stand on, as a straight piece.
struct WoodLine {
    Vec3 lower = Vec3::Zero(); ///< m, middle of the wood at the lower end, or where it leaves thicker wood
    Vec3 upper = Vec3::Zero(); ///< m, middle of the wood at the node
    Vec3 axis = Vec3::UnitY(); ///< Unit vector along it
    float radius = 0.0F;       ///< m; 0 where there is no wood
};

/// The wood of all internodes as strands show it: by internode.
using StrandLines = std::vector<WoodLine>;
/// @p internodes: the number of all internodes of the tree.
StrandLines strandLines(const StrandLayouts& layouts, std::uint32_t internodes);

/// Where the wood of a tree lies that is shown. Where the strands are not known, the wood is tubes, which run
/// along the tree's own nodes.
class WoodLines {
public:
    /// All must outlive this. @p strands may be empty.
    WoodLines(const Tree& tree, const TreeIndex& index, const Widths& widths,
              std::span<const WoodLine> strands = {})
        : m_tree(tree), m_index(index), m_widths(widths), m_strands(strands)
    {
    }

    /// The wood of a living internode.
    WoodLine of(InternodeId id) const;
    /// Its unit vector alone.
    Vec3 axis(InternodeId id) const { return isStrand(id) ? m_strands[id].axis : m_index.heading(id); }

private:
    bool isStrand(InternodeId id) const { return id < m_strands.size() && m_strands[id].radius > 0.0F; }

    const Tree& m_tree;
    const TreeIndex& m_index;
    const Widths& m_widths;
    std::span<const WoodLine> m_strands;
};

} // namespace espalier

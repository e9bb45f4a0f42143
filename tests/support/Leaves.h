// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/LeafPlacer.h"
#include "tests/support/TreeBuilder.h"

namespace espalier::test {

/// All leaves of a tree whose wood is shown as tubes.
inline MeshBuffer<LeafInstance> leavesOf(const TreeBuilder& builder)
{
    return placeLeaves(builder.tree, builder.index, Widths(builder.tree, builder.index));
}

/// The leaves of one internode.
inline std::vector<LeafInstance> leavesOf(const TreeBuilder& builder, InternodeId id)
{
    const Widths widths(builder.tree, builder.index);
    const LeafPlacer placer(builder.tree, builder.index, widths);
    std::vector<LeafInstance> leaves(placer.rule().leavesPerInternode());
    placer.place(id, leaves);
    return leaves;
}

} // namespace espalier::test

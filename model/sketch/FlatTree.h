// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/sketch/DepthInference.h"
#include "model/tree/TreeIndex.h"

#include <vector>

namespace espalier {

/// Whether all nodes of the living wood lie in the plane of a drawing, z = 0, but for a five-hundredth of the
/// tree's size: so it was drawn there, and has no depth yet. A seedling is flat.
bool isFlat(const Tree& tree, const TreeIndex& index);

/// A tree as a drawing: its axes are the branches.
struct TreeDrawing {
    SketchedTree drawing;
    std::vector<std::vector<InternodeId>> axes; ///< By branch of the drawing: its internodes, base first
};
/// The drawing that the seedling's trunk and all that it carries make, seen from the front.
/// Precondition: the seedling is the only living root.
TreeDrawing drawingOf(const Tree& tree, const TreeIndex& index);

/// The edit that gives a flat tree depth (Okabe 2005, 4): all nodes get the depths that inferDepth() finds,
/// their x and y stay; the branches of a second tree are born beside those of the first. Widths go to their
/// copies, and so do the parameters that a branch grew with. Fails (Kind::Input) if the tree is not flat, has
/// no branch to spread, or if other roots stand beside it.
Result<TreeDelta> giveDepth(const Tree& tree, const TreeIndex& index, const DepthOptions& options);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/TreeSketch.h"
#include "model/document/TreeDocument.h"

namespace espalier {

/// The drawing that a sketch's strokes make: smoothed, a pixel being a thousandth of the sketch's diagonal,
/// and joined.
SketchedTree sketchedTree(const TreeSketch& sketch);

/// Makes a tree of a sketch out of the document's seedling, as one undo step: the strokes are smoothed (a
/// pixel being a thousandth of the sketch's diagonal), joined (SketchedTree), given depths (inferDepth()) and
/// divided into internodes of the length that the parameters of growth have (skeletonOf()). The trunk's foot
/// moves to the world's origin. Loops become placed leaves (skeletonLeavesOf()). Fails (Kind::Input), and
/// changes nothing, if anything else than a seedling stands there, if no stroke is a branch, or if the
/// branches cannot become a tree.
Result<void> drawSketch(TreeDocument& document, TreeSketch sketch);

} // namespace espalier

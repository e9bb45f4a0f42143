// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/sketch/LeafSuggestions.h"

namespace espalier {

/// Places a leaf, a flower or a fruit (internode, along, rotation, length and kind of @p leaf; its birth is
/// the present step) as one undo step. Returns false, and changes nothing, if the internode does not live, or
/// if a value is out of its range (isLeafPlace()).
bool placeLeaf(TreeDocument& document, LeafRow leaf);

/// Does what an engine suggests for the leaf that is nearest to @p place (suggestLeaves()), as one undo step.
/// Returns false, and changes nothing, if the engine suggests nothing there.
bool arrangeLeaves(TreeDocument& document, LeafEngine engine, const BranchPlace& place);

} // namespace espalier

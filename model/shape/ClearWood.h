// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <vector>

namespace espalier {

/// How far along its axis, from the axis's base, the place @p along the living internode @p id is, m.
float lengthBelow(const Tree& tree, const TreeIndex& index, InternodeId id, float along);

/// The living branches that are attached to the axis of @p id nearer to its base than @p length, m;
/// ascending.
std::vector<InternodeId> shootsBelow(const Tree& tree, const TreeIndex& index, InternodeId id, float length);

/// Keeps the axis of @p id clear from its base up to @p length, m: the branches that are attached there and
/// the leaves that the user has placed there go, the lateral buds there rest, and so do those of internodes
/// with which the axis grows on within that length. Buds beyond the length that rested because of it are
/// active again; a length of 0 lets all of them shoot. The length is clamped to kGreatestClearLength. Empty
/// if nothing changes, or if @p id is dead or unknown.
TreeDelta keepClear(const Tree& tree, const TreeIndex& index, InternodeId id, float length);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthStep.h"

namespace espalier {

/// A growth step of the vigour model without a brush: a month (EvoEngine 2024; Strands 2024 §4.1). Tips
/// lengthen, and pass on to a new internode when theirs is long enough; lateral buds break; branches sag
/// under the new weight; shaded ends are shed. Vigour that was added (addedVigour) lets its subtree grow up
/// to three times as much, with longer internodes and more laterals, until it is used up. The delta is empty
/// if nothing grew.
TreeDelta vigourStep(const Tree& tree, const TreeIndex& index, const VoxelSpace& space,
                     const GrowthStepOptions& options, GrowthWorkspace& workspace);

/// A growth step of the vigour model under a brush: half a year, in which only the buds that perceive
/// markers grow, toward them, and as if they had more light. Occupied markers are removed.
TreeDelta vigourStepToward(const Tree& tree, const TreeIndex& index, const VoxelSpace& space,
                           MarkerSet& markers, const GrowthStepOptions& options, GrowthWorkspace& workspace);

/// Adds @p added years of vigour to the living internode @p subtree, and lets the subtree use up to @p used
/// years of what it then has. Only the subtree grows, by that vigour alone, whichever model is in force. The
/// time of the tree advances by a step. Precondition: the sum is at most kMostAddedVigour.
TreeDelta invigorate(const Tree& tree, const TreeIndex& index, const VoxelSpace& space, InternodeId subtree,
                     double added, double used, GrowthWorkspace& workspace);

} // namespace espalier

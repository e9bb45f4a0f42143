// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowingTree.h"

#include <span>

namespace espalier {

/// Lets young wood straighten as reaction wood does: where a lateral has taken over from its axis, or an axis
/// has changed its direction, a part of the turn goes over to the internodes around it. The path below each
/// node of @p growingAt is followed down for some internodes, as long as it carries the most tips. What
/// stands at the ends of the path keeps its direction. What was drawn stays as it is, and so does what could
/// get below the ground. The share of a turn is GrowthParameters::straightening.
void straightenWood(GrowingTree& growing, std::span<const InternodeId> growingAt, GrowthWorkspace& workspace);

} // namespace espalier

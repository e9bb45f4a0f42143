// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"
#include "model/tree/TreeIndex.h"

#include <vector>

namespace espalier {

/// The internodes that a twist reaches from the one that it is given to.
enum class TwistScope {
    Branch,  ///< That one, and those that continue its axis up to the tip
    Subtree, ///< That one, and all that it carries
};

/// The greatest twist from one node to the next, rad.
inline constexpr double kMostTwist = radians(180);

/// The living internodes that a twist of @p id reaches, ascending; none if @p id is dead or unknown.
std::vector<InternodeId> twistedInternodes(const Tree& tree, const TreeIndex& index, InternodeId id,
                                           TwistScope scope);

/// Turns the section of each of these internodes against the one below it by @p angle, rad, within
/// ±kMostTwist, in place of the twist that it has (Strands 2024 §5.4); 0 takes the twist away. Above 0,
/// strands wind to the left on their way up; seen from the tip, they turn clockwise.
TreeDelta twist(const Tree& tree, const TreeIndex& index, InternodeId id, TwistScope scope, double angle);

} // namespace espalier

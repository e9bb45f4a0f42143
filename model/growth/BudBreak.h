// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VigourFlux.h"

namespace espalier {

/// The chance that a lateral bud at the node of @p id breaks in this step: the flushing rate, lowered by the
/// inhibitor, for each internode that a shoot at the node would grow (EvoEngine 2024); 0...1. Added vigour
/// raises it.
double breakChance(const VigourFlux& flux, const VigourParameters& parameters, InternodeId id);

/// The lateral and adventitious buds that break in this step, by ascending node and slot. A bud waits until
/// the shoot has grown past its node; axes of the highest order, and the bare part of the trunk, do not
/// branch. The same random number
/// decides about a bud at any chance.
std::vector<BudRef> breakingBuds(const GrowingTree& growing, const VigourFlux& flux,
                                 const VigourParameters& parameters);

/// Whether the bud breaks at @p chance in the step that the tree is about to make.
bool breaks(const GrowingTree& growing, const BudRef& bud, double chance);

} // namespace espalier

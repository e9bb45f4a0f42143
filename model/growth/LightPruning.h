// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VigourFlux.h"

namespace espalier {

/// The height below which trunks are bare of branches, m: the more a species sheds in the shade, the higher.
double bareHeight(const VigourFlux& flux, const VigourParameters& parameters);

/// Sheds internodes without children that have less light than the parameter says, so that a branch goes
/// from its ends on, step by step; and the whole branches that begin on a trunk below bareHeight() (Li 2023;
/// EvoEngine 2024). Young internodes and the trunks stay. Returns which internodes are shed, by id; empty if
/// none can be.
std::vector<std::uint8_t> pruneShaded(GrowingTree& growing, const VigourFlux& flux, const VoxelSpace& space,
                                      const VigourParameters& parameters);

} // namespace espalier

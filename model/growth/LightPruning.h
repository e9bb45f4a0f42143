// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VigourFlux.h"

#include <span>
#include <vector>

namespace espalier {

/// The height below which trunks are bare of branches, m: the more a species sheds in the shade, the higher.
double bareHeight(const VigourFlux& flux, const VigourParameters& parameters);

/// Sheds internodes without children that have less light than the parameter says, so that a branch goes
/// from its ends on, step by step; and the whole branches that begin on a trunk below the height @p bare, m
/// (Li 2023; EvoEngine 2024). Young internodes, the trunks, axes that a person placed and the @p spared
/// internodes (ascending) stay. Returns which internodes are shed, by id; empty if none can be.
std::vector<std::uint8_t> pruneShaded(GrowingTree& growing, const VigourFlux& flux, const VoxelSpace& space,
                                      const VigourParameters& parameters, double bare,
                                      std::span<const InternodeId> spared = {});

} // namespace espalier

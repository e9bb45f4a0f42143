// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/BrushGesture.h"
#include "commands/GrowGesture.h"
#include "model/base/Random.h"
#include "model/shape/Widths.h"

#include <span>
#include <vector>

namespace espalier::test {

/// Random parameters of growth that an artist might set: shapes of all kinds that stay small.
TreeParameters randomParameters(Random& random);

/// A stroke along @p points, evenly timed over @p seconds, sixty samples a second.
std::vector<BrushSample> strokeAlong(std::span<const Vec3> points, float radius, double seconds);
/// A stroke that wanders at random near the tree, of up to @p seconds.
std::vector<BrushSample> randomStroke(Random& random, const GrowthParameters& growth, double seconds);

/// Makes a whole stroke, one undo step if anything grew.
void brush(TreeDocument& document, std::span<const BrushSample> samples, Competitors competitors = {});
/// Grows @p steps steps without a brush, as one undo step if anything grew; returns how many of them grew
/// something.
int grow(TreeDocument& document, int steps, Competitors competitors = {});

/// Resets @p document to a seedling with random parameters and grows it, with brush and without, to at least
/// @p least internodes where its parameters allow that, and hardly more than @p most.
void growAtRandom(TreeDocument& document, std::uint64_t seed, std::uint32_t least = 60,
                  std::uint32_t most = 500);

/// The diameter of an internode by @p widths, m.
double diameterOf(const Widths& widths, const TreeIndex& index, InternodeId id);

} // namespace espalier::test

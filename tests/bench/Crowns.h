// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <vector>

namespace espalier::test {

/// CPU seconds of all threads of this process.
double cpuTime();
double median(std::vector<double> samples);
double worst(const std::vector<double>& samples);

/// Grows without a brush until the tree has @p internodes living internodes.
void growTo(TreeDocument& document, std::uint32_t internodes);
/// A well-shaped crown of so many internodes, grown without a brush by the default parameters. It is made
/// once and shared, so restore it after changes.
TreeDocument& crown(std::uint32_t internodes);

} // namespace espalier::test

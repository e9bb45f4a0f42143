// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <vector>

namespace espalier::test {

/// CPU seconds of all threads of this process.
double cpuTime();
double median(std::vector<double> samples);
double worst(const std::vector<double>& samples);

/// Grows without a hand until there are so many living internodes.
void growTo(TreeDocument& document, std::uint32_t internodes);
/// A well-shaped crown of so many internodes, grown without a hand by the default parameters; made once, so
/// leave it as it was.
TreeDocument& crown(std::uint32_t internodes);

} // namespace espalier::test

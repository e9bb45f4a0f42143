// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/document/TreeDocument.h"

#include <cstdint>

namespace espalier {

/// Adds branches to the branch of @p id, by the example of those that it carries (multiplied()), one after
/// another, as one undo step. @p count: how many, 1...MultiplyOperation::kMostCount (clamped). Changes
/// nothing if multiplied() fails, and returns its error.
Result<void> multiplyBranch(TreeDocument& document, InternodeId id, std::uint64_t seed, int count = 1);

} // namespace espalier

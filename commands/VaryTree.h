// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/CommandTrial.h"
#include "model/base/Error.h"
#include "model/document/TreeDocument.h"

#include <cstdint>

namespace espalier {

/// Changes the angles and lengths of the document's trees slightly (varied()), as one undo step. @p amount:
/// up to 1; below VaryOperation::kLeastAmount nothing happens. Changes nothing if varied() fails, and returns
/// its error.
Result<void> varyTree(TreeDocument& document, std::uint64_t seed, double amount);

/// Variations of a tree that are tried out one after another.
class VariationTrial : public CommandTrial {
public:
    using CommandTrial::CommandTrial;

    /// Does and fails as varyTree() does; if it fails, a trial before it stays.
    Result<void> tryOut(std::uint64_t seed, double amount);
};

} // namespace espalier

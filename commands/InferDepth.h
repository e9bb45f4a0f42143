// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/CommandTrial.h"
#include "model/document/TreeDocument.h"
#include "model/sketch/DepthInference.h"

namespace espalier {

/// Gives a drawn tree depth (giveDepth()), as one undo step. Fails (Kind::Input), and changes nothing, as
/// that does.
Result<void> inferDepth(TreeDocument& document, const DepthOptions& options);

/// The depth of a drawn tree while its options are tried out.
class DepthTrial : public CommandTrial {
public:
    using CommandTrial::CommandTrial;

    /// Fails as inferDepth() does; then a trial before it stays.
    Result<void> tryOut(const DepthOptions& options);
};

} // namespace espalier

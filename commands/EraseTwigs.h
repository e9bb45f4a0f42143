// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/EraseOperation.h"
#include "commands/recipe/ThinOperation.h"
#include "model/document/TreeDocument.h"
#include "model/shape/Twigs.h"

namespace espalier {

/// Takes away the thin wood and the placed leaves that the eraser has swept, as one undo step. Returns
/// whether there were any.
bool eraseTwigs(TreeDocument& document, const EraseOperation& operation);

/// Takes away a share of the twigs that the brush has swept, as one undo step. Returns whether there were
/// any.
bool thinTwigs(TreeDocument& document, const ThinOperation& operation);

} // namespace espalier

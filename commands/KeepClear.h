// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/shape/ClearWood.h"

namespace espalier {

/// Keeps the axis of @p id clear of shoots over @p length from its base, m, as one undo step
/// (model/shape/ClearWood); 0 lets its buds shoot again. Returns whether anything has changed.
bool keepClear(TreeDocument& document, InternodeId id, float length);

} // namespace espalier

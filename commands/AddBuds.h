// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/shape/AdventitiousBuds.h"

namespace espalier {

/// The buds that addBuds() would make, for a preview. @p radius: of the bark, m.
std::vector<BarkBud> budsOf(const TreeDocument& document, const BudSpiral& spiral,
                            const std::function<float(InternodeId)>& radius);

/// Adds the buds of @p spiral as one undo step; returns how many. They grow in later growth steps.
int addBuds(TreeDocument& document, const BudSpiral& spiral);

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "views/tools/BranchPicker.h"

namespace espalier {

/// A living bud as it is shown.
struct PickedBud {
    BudRef bud;
    Vec3 position = Vec3::Zero(); ///< Of its dot, just outside the bark, m
};

/// The living buds that appear at most @p reach px from @p screen, the nearest first; of those as near as
/// makes no difference, those in front.
std::vector<PickedBud> pickBuds(const PickScene& scene, const QPointF& screen, double reach);

/// Where a bud is shown, m.
Vec3 budPosition(const Tree& tree, const TreeIndex& index, const BudRef& bud, float radius);

} // namespace espalier

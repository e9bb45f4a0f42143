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

/// More buds than anybody tells apart around a pointer.
inline constexpr std::size_t kMostPickedBuds = 200;

/// The living buds that appear at most @p reach px from @p screen, the nearest first, at most @p most (≥ 1)
/// of them; of those as near as makes no difference, those in front come first.
std::vector<PickedBud> pickBuds(const PickScene& scene, const QPointF& screen, double reach,
                                std::size_t most = kMostPickedBuds);

/// Where a bud is shown, m.
Vec3 budPosition(const Tree& tree, const TreeIndex& index, const BudRef& bud, float radius);

} // namespace espalier

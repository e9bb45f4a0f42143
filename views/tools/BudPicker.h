// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "views/tools/BranchPicker.h"

namespace espalier {

/// A living bud and its place on the screen's picture.
struct PickedBud {
    BudRef bud;
    Vec3 position = Vec3::Zero(); ///< Place of the bud's dot, just outside the bark, m
};

/// The most buds around a pointer that are worth showing.
inline constexpr std::size_t kMostPickedBuds = 200;

/// The living buds that appear at most @p reach px from @p screen, the nearest first, at most @p most (≥ 1)
/// of them; of buds at practically the same distance, those in front come first.
std::vector<PickedBud> pickBuds(const PickScene& scene, const QPointF& screen, double reach,
                                std::size_t most = kMostPickedBuds);

/// Place at which a bud's dot is drawn, m.
Vec3 budPosition(const Tree& tree, const TreeIndex& index, const BudRef& bud, float radius);

} // namespace espalier

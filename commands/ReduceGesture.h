// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/HoldGesture.h"

namespace espalier {

/// The inverse of InvigorateGesture: as long as a branch is held, its youngest internodes go, one birth step
/// after another, and the buds that they grew from are active again.
class ReduceGesture final : public HoldGesture {
public:
    ReduceGesture(TreeDocument& document, InternodeId branch);

private:
    TreeDelta step(const TreeDocument& document) override;
    RecipeOperation operation() const override;
};

} // namespace espalier

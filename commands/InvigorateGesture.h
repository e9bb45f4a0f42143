// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/HoldGesture.h"
#include "model/growth/GrowingTree.h"

namespace espalier {

/// Vigour for a branch (Strands 2024 §5, interactive invigoration): as long as it is held, vigour is added to
/// it, and its subtree grows by that vigour, whichever growth model is in force. Two thirds of the vigour are
/// used at once; the vigour model uses the rest in its next growth steps.
class InvigorateGesture final : public HoldGesture {
public:
    InvigorateGesture(TreeDocument& document, InternodeId branch);

private:
    TreeDelta step(const TreeDocument& document) override;
    RecipeOperation operation() const override;

    GrowthWorkspace m_workspace;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/InvigorateGesture.h"
#include "views/tools/HoldTool.h"

#include <QCoreApplication>

namespace espalier {

/// Gives vigour to the branch that is pressed (Strands 2024 §5): it alone grows.
class InvigorateTool : public HoldTool {
    Q_DECLARE_TR_FUNCTIONS(InvigorateTool)

public:
    using HoldTool::HoldTool;

    QString tip() const override { return tr("Press a branch and hold: it grows until you let go"); }

private:
    std::unique_ptr<HoldGesture> makeGesture(TreeDocument& document, InternodeId branch) const override
    {
        return std::make_unique<InvigorateGesture>(document, branch);
    }
    QColor ringColour() const override { return {120, 214, 255}; }
    bool ringsGrow() const override { return true; }
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/ReduceGesture.h"
#include "views/tools/HoldTool.h"

#include <QCoreApplication>

namespace espalier {

/// Takes the youngest growth of the branch that is pressed away.
class ReduceTool : public HoldTool {
    Q_DECLARE_TR_FUNCTIONS(ReduceTool)

public:
    using HoldTool::HoldTool;

    QString tip() const override { return tr("Press a branch and hold: it shrinks until you let go"); }

private:
    std::unique_ptr<HoldGesture> makeGesture(TreeDocument& document, InternodeId branch) const override
    {
        return std::make_unique<ReduceGesture>(document, branch);
    }
    QColor ringColour() const override { return {255, 168, 96}; }
    bool ringsGrow() const override { return false; }
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"

#include "commands/DeltaCommand.h"

#include <QCoreApplication>

namespace espalier {

void setParameters(TreeDocument& document, const TreeParameters& parameters)
{
    if (parameters == document.parameters())
        return;
    auto delta = std::make_shared<TreeDelta>(TreeDelta::startingAt(document.tree()));
    delta->parametersAfter = document.rememberParameters(parameters);
    document.apply(delta);
    document.undoStack().push(new DeltaCommand(
        document, QCoreApplication::translate("Commands", "Change Parameters"), {std::move(delta)}));
}

} // namespace espalier

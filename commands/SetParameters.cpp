// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/SetParametersOperation.h"

#include <QCoreApplication>

namespace espalier {

bool setParameters(TreeDocument& document, const TreeParameters& parameters)
{
    Edit edit(document);
    const Tree& tree = document.tree();
    if (!tree.hasRoomFor(parameters))
        return false;
    TreeDelta delta = deltaStartingAt(tree);
    delta.parametersAfter = keepParameters(delta, tree, parameters);
    edit.apply(std::move(delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Change Parameters"),
                   [&] { return SetParametersOperation{parameters}; });
    return true;
}

} // namespace espalier

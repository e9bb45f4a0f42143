// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"

#include "model/document/Edit.h"

#include <QCoreApplication>

namespace espalier {

void setParameters(TreeDocument& document, const TreeParameters& parameters)
{
    Edit edit(document);
    const Tree& tree = document.tree();
    if (!tree.hasRoomFor(parameters))
        return;
    TreeDelta delta = deltaStartingAt(tree);
    delta.parametersAfter = keepParameters(delta, tree, parameters);
    edit.apply(std::move(delta));
    edit.commit(QCoreApplication::translate("Commands", "Change Parameters"));
}

} // namespace espalier

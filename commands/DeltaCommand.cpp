// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DeltaCommand.h"

#include <algorithm>

namespace espalier {

DeltaCommand::DeltaCommand(TreeDocument& document, QString text, Journal appliedDeltas)
    : QUndoCommand(std::move(text)), m_document(document), m_deltas(std::move(appliedDeltas))
{
}

void DeltaCommand::undo()
{
    for (std::size_t i = 0; i < m_deltas.size(); ++i)
        m_document.revertLast();
    m_applied = false;
}

void DeltaCommand::redo()
{
    if (std::exchange(m_applied, true))
        return;
    for (const auto& delta : m_deltas)
        m_document.apply(delta);
}

} // namespace espalier

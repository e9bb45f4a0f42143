// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DeltaCommand.h"

#include <algorithm>

namespace espalier {

DeltaCommand::DeltaCommand(TreeDocument& document, QString text, Journal appliedDeltas,
                           Journal replacedDeltas)
    : QUndoCommand(std::move(text)),
      m_document(document),
      m_deltas(std::move(appliedDeltas)),
      m_replaced(std::move(replacedDeltas))
{
}

void DeltaCommand::undo()
{
    revertAll(m_document, m_deltas);
    applyAll(m_document, m_replaced);
    m_applied = false;
}

void DeltaCommand::redo()
{
    if (std::exchange(m_applied, true))
        return;
    revertAll(m_document, m_replaced);
    applyAll(m_document, m_deltas);
}

void revertAll(TreeDocument& document, const Journal& deltas)
{
    for (std::size_t i = 0; i < deltas.size(); ++i)
        document.revertLast();
}

void applyAll(TreeDocument& document, const Journal& deltas)
{
    for (const auto& delta : deltas)
        document.apply(delta);
}

} // namespace espalier

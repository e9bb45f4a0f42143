// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DeltaCommand.h"

#include <algorithm>

namespace espalier {

DeltaCommand::DeltaCommand(TreeDocument& document, QString text, Journal appliedDeltas)
    : QUndoCommand(std::move(text)),
      m_document(document),
      m_deltas(std::move(appliedDeltas)),
      m_lost(document.takeFuture())
{
}

DeltaCommand::DeltaCommand(const DeltaCommand& other)
    : QUndoCommand(other.text()),
      m_document(other.m_document),
      m_deltas(other.m_deltas),
      m_lost(other.m_lost),
      m_applied(other.m_applied)
{
}

std::unique_ptr<DeltaCommand> DeltaCommand::copy() const
{
    return std::unique_ptr<DeltaCommand>(new DeltaCommand(*this));
}

void DeltaCommand::undo()
{
    for (std::size_t i = 0; i < m_deltas.size(); ++i)
        m_document.revertLast();
    m_document.setFuture(m_lost);
    m_applied = false;
}

void DeltaCommand::redo()
{
    if (std::exchange(m_applied, true))
        return;
    m_document.setFuture({});
    for (const auto& delta : m_deltas)
        m_document.apply(delta);
}

int DeltaCommand::id() const
{
    return m_lost.empty() ? -1 : kTimeTravelId;
}

} // namespace espalier

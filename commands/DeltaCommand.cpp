// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DeltaCommand.h"

#include <algorithm>

namespace espalier {

DeltaCommand::DeltaCommand(TreeDocument& document, QString text, Journal appliedDeltas,
                           Journal replacedDeltas)
    : QUndoCommand(std::move(text)),
      m_document(document),
      m_deltas(std::move(appliedDeltas)),
      m_replaced(std::move(replacedDeltas)),
      m_lost(document.takeFuture())
{
}

DeltaCommand::DeltaCommand(const DeltaCommand& other)
    : QUndoCommand(other.text()),
      m_document(other.m_document),
      m_deltas(other.m_deltas),
      m_replaced(other.m_replaced),
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
    revertAll(m_document, m_deltas);
    applyAll(m_document, m_replaced);
    m_document.setFuture(m_lost);
    m_applied = false;
}

void DeltaCommand::redo()
{
    if (std::exchange(m_applied, true))
        return;
    m_document.setFuture({});
    revertAll(m_document, m_replaced);
    applyAll(m_document, m_deltas);
}

int DeltaCommand::id() const
{
    return m_lost.empty() ? -1 : kTimeTravelId;
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

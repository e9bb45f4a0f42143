// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/EditCommand.h"

#include "model/document/PreparedTree.h"

namespace espalier {

EditCommand::EditCommand(TreeDocument& document, const QString& text, Content content, State state)
    : QUndoCommand(text),
      m_document(document),
      m_content(std::move(content)),
      m_applied(state == State::Done ? m_content.deltas.size() : 0),
      m_takenOut(state == State::Done ? m_content.replaced.size() : 0),
      m_isExchanged(state == State::Done)
{
}

EditCommand& EditCommand::at(const QUndoStack& stack, int index)
{
    return const_cast<EditCommand&>(static_cast<const EditCommand&>(*stack.command(index)));
}

void EditCommand::undo()
{
    if (m_isHandedOver || m_isAsleep)
        return;
    while (stepBack()) {
    }
}

void EditCommand::redo()
{
    if (m_isAsleep)
        return;
    while (stepForward()) {
    }
}

bool EditCommand::stepBack()
{
    if (m_content.other)
        return exchangeTowards(false);
    if (m_applied == 0 && m_takenOut == 0)
        return travelOneTowards(m_content.from);
    if (m_applied > 0) {
        m_document.revertLast();
        --m_applied;
    } else {
        m_document.apply(m_content.replaced[m_content.replaced.size() - m_takenOut]);
        --m_takenOut;
    }
    if (m_applied == 0 && m_takenOut == 0)
        m_document.setFuture(m_content.future);
    return true;
}

bool EditCommand::stepForward()
{
    if (m_content.other)
        return exchangeTowards(true);
    if (m_applied == 0 && m_takenOut == 0) {
        if (travelOneTowards(m_content.to))
            return true;
        if (!isTravel())
            m_document.setFuture({});
    }
    if (m_takenOut < m_content.replaced.size()) {
        m_document.revertLast();
        ++m_takenOut;
    } else if (m_applied < m_content.deltas.size()) {
        m_document.apply(m_content.deltas[m_applied]);
        ++m_applied;
    } else {
        return false;
    }
    return true;
}

bool EditCommand::exchangeTowards(bool forward)
{
    if (std::exchange(m_isExchanged, forward) == forward)
        return false;
    m_document.swapWith(*m_content.other);
    return true;
}

/// Travels by one delta; returns false if the document is at @p position already.
bool EditCommand::travelOneTowards(std::size_t position)
{
    const std::size_t here = m_document.journal().size();
    if (here == position)
        return false;
    m_document.travelTo(here < position ? here + 1 : here - 1);
    return true;
}

void EditCommand::handOver()
{
    m_isHandedOver = true;
    setObsolete(true);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/EditCommand.h"

namespace espalier {

EditCommand::EditCommand(TreeDocument& document, const QString& text, Content content)
    : QUndoCommand(text), m_document(document), m_content(std::move(content))
{
}

void EditCommand::undo()
{
    if (m_isHandedOver)
        return;
    for (std::size_t i = 0; i < m_content.deltas.size(); ++i)
        m_document.revertLast();
    for (const auto& delta : m_content.replaced)
        m_document.apply(delta);
    if (!isTravel())
        m_document.setFuture(m_content.future);
    m_document.travelTo(m_content.from);
    m_isApplied = false;
}

void EditCommand::redo()
{
    if (std::exchange(m_isApplied, true))
        return;
    m_document.travelTo(m_content.to);
    if (isTravel())
        return;
    m_document.setFuture({});
    for (std::size_t i = 0; i < m_content.replaced.size(); ++i)
        m_document.revertLast();
    for (const auto& delta : m_content.deltas)
        m_document.apply(delta);
}

void EditCommand::handOver()
{
    m_isHandedOver = true;
    setObsolete(true);
}

} // namespace espalier

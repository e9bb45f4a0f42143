// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/Edit.h"

#include "model/document/EditCommand.h"

namespace espalier {

namespace {

using Event = EditEvent::Kind;

EditCommand& lastCommand(const QUndoStack& stack)
{
    return EditCommand::at(stack, stack.index() - 1);
}

} // namespace

Edit::Edit(TreeDocument& document, Interrupted interrupted, Kind kind)
    : m_document(document), m_interrupted(std::move(interrupted))
{
    if (kind == Kind::ParameterTrial)
        document.interruptOpenEdit();
    else
        document.interruptEdit();
    document.setEdit(this, {m_interrupted, [this] { cancel(); }});
    m_from = m_to = document.journal().size();
    document.note({Event::Began});
}

std::unique_ptr<Edit> Edit::resumed(TreeDocument& document, Kind kind)
{
    auto edit = std::make_unique<Edit>(document, Interrupted(), kind);
    QUndoStack& stack = document.undoStack();
    Q_ASSERT(stack.index() > 0);
    EditCommand& last = lastCommand(stack);
    const EditCommand::Content& content = last.content();
    edit->m_from = content.from;
    edit->m_to = content.to;
    edit->m_replaced = content.replaced;
    edit->m_deltas = content.deltas;
    edit->m_future = content.future;
    document.note({Event::Resumed});
    last.handOver();
    stack.undo();
    return edit;
}

Edit::~Edit()
{
    cancel();
}

void Edit::apply(TreeDelta delta)
{
    Q_ASSERT(isActive());
    if (delta.isEmpty())
        return;
    if (m_deltas.empty() && m_replaced.empty())
        m_future = m_document.takeFuture();
    // The record marks the beginning of this edit. Without it, the delta would count as one of the edit
    // before if the journal has that edit only in part.
    if (m_deltas.empty() && !delta.record)
        delta.record = EditRecord::unknown();
    delta.squeeze();
    if (m_document.m_editListener)
        m_document.note({Event::Applied, std::make_unique<TreeDelta>(delta)});
    m_deltas.push_back(std::make_shared<TreeDelta>(std::move(delta)));
    m_document.apply(m_deltas.back());
}

void Edit::takeBackLast()
{
    Q_ASSERT(isActive() && !m_deltas.empty());
    m_document.note({Event::TookBackLast});
    m_document.revertLast();
    m_deltas.pop_back();
    if (m_deltas.empty() && m_replaced.empty())
        m_document.setFuture(std::move(m_future));
}

void Edit::takeBack()
{
    while (!m_deltas.empty())
        takeBackLast();
}

void Edit::show(TreeDelta delta)
{
    takeBack();
    apply(std::move(delta));
}

void Edit::replaceFrom(std::size_t position)
{
    Q_ASSERT(isActive() && m_deltas.empty() && m_replaced.empty());
    const Journal& journal = m_document.journal();
    Journal replaced(journal.begin() + static_cast<std::ptrdiff_t>(position), journal.end());
    if (replaced.empty())
        return;
    m_document.note({.kind = Event::ReplacedFrom, .position = position});
    m_future = m_document.takeFuture();
    for (std::size_t i = 0; i < replaced.size(); ++i)
        m_document.revertLast();
    m_replaced = std::move(replaced);
}

void Edit::travelTo(std::size_t position)
{
    Q_ASSERT(isActive() && m_deltas.empty() && m_replaced.empty());
    m_document.note({.kind = Event::TravelledTo, .position = position});
    m_document.travelTo(position);
    m_to = position;
}

void Edit::record(const QByteArray& operation)
{
    if (operation.isEmpty() || operation.size() > EditRecord::kMostBytes || m_deltas.empty())
        return;
    // A copy, since another thread may read the delta in a snapshot of the journal.
    auto first = std::make_shared<TreeDelta>(*m_deltas.front());
    first->record = std::make_shared<const EditRecord>(
        EditRecord{operation, static_cast<std::uint32_t>(m_deltas.size())});
    m_document.m_journal[m_document.m_journal.size() - m_deltas.size()] = first;
    m_deltas.front() = std::move(first);
}

void Edit::commit(const QString& text, const QByteArray& operation)
{
    if (m_hasEnded)
        return;
    m_document.note({.kind = Event::Committed, .text = text, .operation = operation});
    record(operation);
    end();
    if (!hasChanges())
        return;
    QUndoStack& stack = m_document.undoStack();
    // A travel and an edit at the moment that it led to are one step: one undo restores the future that the
    // edit ended. Consecutive travels are one step, too, and none if they lead back. But the commands that
    // can be redone begin at the moment that the last travel led to. So if there are any, a travel that leads
    // back is a step of its own, which clears them.
    std::size_t from = m_from;
    const bool isTravel = m_deltas.empty() && m_replaced.empty();
    if (stack.index() > 0 && lastCommand(stack).isTravel() && (isTravel || !m_future.empty())) {
        EditCommand& last = lastCommand(stack);
        from = last.content().from;
        const bool leadsBack = isTravel && from == m_to;
        if (!leadsBack || !stack.canRedo()) {
            last.handOver();
            stack.undo();
        } else {
            from = m_from;
        }
        if (leadsBack && from == m_to)
            return;
    }
    stack.push(new EditCommand(
        m_document, text, {from, m_to, std::move(m_replaced), std::move(m_deltas), std::move(m_future)}));
}

void Edit::cancel()
{
    if (m_hasEnded)
        return;
    takeBack();
    m_document.note({Event::Cancelled});
    if (!m_replaced.empty()) {
        for (const auto& delta : m_replaced)
            m_document.apply(delta);
        m_replaced.clear();
        m_document.setFuture(std::move(m_future));
    }
    m_document.travelTo(m_from);
    end();
}

void Edit::end()
{
    m_hasEnded = true;
    m_document.setEdit(nullptr);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TreeDocument that makes undo steps of another tree, and of a history that was read.
#include "model/document/EditCommand.h"
#include "model/document/PreparedTree.h"
#include "model/document/TreeDocument.h"
#include "model/tree/JournalEdit.h"

#include <QCoreApplication>
#include <QSignalBlocker>

#include <span>

namespace espalier {

/// Fills the undo stack, which is empty, with the steps that the history tells of, as if they had just been
/// done, and makes it clean.
void TreeDocument::restoreSteps()
{
    Journal history = m_journal;
    history.insert(history.end(), m_future.rbegin(), m_future.rend());
    if (history.empty())
        return;
    {
        // A view of the stack would be filled again with each step.
        const QSignalBlocker blocker(m_undoStack);
        for (std::size_t i = 0; i < history.size();) {
            const JournalEdit edit = JournalEdit::at(history, i);
            const EditRecord* record = history[i]->record.get();
            EditCommand::Content content;
            content.from = content.to = edit.first;
            const auto deltas = std::span(history).subspan(edit.first, edit.end - edit.first);
            content.deltas.assign(deltas.begin(), deltas.end());
            const QString name = record && !record->step.isEmpty()
                                     ? record->step
                                     : QCoreApplication::translate("Commands", "Earlier Step");
            m_undoStack.push(new EditCommand(*this, name, std::move(content)));
            i = edit.end;
        }
        if (!m_future.empty()) {
            EditCommand::Content travel;
            travel.from = history.size();
            travel.to = m_journal.size();
            const QString name = QCoreApplication::translate("Commands", "Travel in Time");
            m_undoStack.push(new EditCommand(*this, name, std::move(travel)));
        }
        m_undoStack.setClean();
    }
    Q_EMIT m_undoStack.indexChanged(m_undoStack.index());
    Q_EMIT m_undoStack.canUndoChanged(m_undoStack.canUndo());
    Q_EMIT m_undoStack.undoTextChanged(m_undoStack.undoText());
}

void TreeDocument::reset(PreparedTree prepared)
{
    const SceneLook look = prepared.look.value_or(SceneLook());
    replaceBy(std::move(prepared));
    restoreSteps();
    setLook(look);
}

void TreeDocument::exchange(PreparedTree prepared, const QString& text)
{
    interruptEdit();
    EditCommand::Content content;
    content.other = std::make_shared<PreparedTree>(std::move(prepared));
    swapWith(*content.other);
    m_undoStack.push(new EditCommand(*this, text, std::move(content)));
}

} // namespace espalier

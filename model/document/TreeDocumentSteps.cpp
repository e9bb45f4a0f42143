// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TreeDocument that makes undo steps of another tree, and of a history that was read.
#include "model/document/EditCommand.h"
#include "model/document/HistorySnapshot.h"
#include "model/document/PreparedTree.h"
#include "model/document/TreeDocument.h"

#include <QSignalBlocker>

#include <algorithm>

namespace espalier {

/// Fills the undo stack, which is empty, and makes it clean.
void TreeDocument::restoreSteps(std::vector<RestoredStep> steps)
{
    if (steps.empty())
        return;
    const std::size_t limit =
        m_undoStack.undoLimit() > 0 ? static_cast<std::size_t>(m_undoStack.undoLimit()) : steps.size();
    {
        // A view of the stack would be filled again with each step.
        const QSignalBlocker blocker(m_undoStack);
        for (std::size_t i = steps.size() - std::min(limit, steps.size()); i < steps.size(); ++i) {
            const JournalEdit& deltas = steps[i].deltas;
            EditCommand::Content content;
            if (deltas.first == deltas.end) {
                content.from = m_journal.size() + m_future.size();
                content.to = m_journal.size();
            } else {
                content.from = content.to = deltas.first;
                for (std::size_t at = deltas.first; at < deltas.end; ++at)
                    content.deltas.push_back(deltaAt(at));
            }
            m_undoStack.push(new EditCommand(*this, steps[i].title, std::move(content)));
        }
        m_undoStack.setClean();
    }
    tellOfStack();
}

/// What a stack that was filled with its signals blocked did not tell.
void TreeDocument::tellOfStack()
{
    Q_EMIT m_undoStack.indexChanged(m_undoStack.index());
    Q_EMIT m_undoStack.canUndoChanged(m_undoStack.canUndo());
    Q_EMIT m_undoStack.undoTextChanged(m_undoStack.undoText());
}

void TreeDocument::reset(PreparedTree prepared)
{
    const SceneLook look = prepared.look.value_or(SceneLook());
    std::vector<RestoredStep> steps = std::move(prepared.steps);
    replaceBy(std::move(prepared));
    restoreSteps(std::move(steps));
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

bool TreeDocument::shorten(ShortenedHistory& shortened)
{
    if (m_edit || shortened.revision != m_revision)
        return false;
    AsideDocument& document = shortened.document;
    document.cleanIndex = std::max(m_undoStack.cleanIndex() - shortened.steps, -1);
    document.undoLimit = m_undoStack.undoLimit();
    if (!m_competitors.areAll())
        m_competitors.node = shortened.internodes[m_competitors.node];
    {
        const QSignalBlocker blocker(m_undoStack);
        std::vector<AsideDocument::Step> before = AsideDocument::stepsOf(*this);
        m_undoStack.clear();
        swapTree(document.tree);
        document.fillStack(*this);
        document.steps = std::move(before);
    }
    tell({TreeChange::Kind::Renumbered, nullptr, &shortened.internodes});
    tellOfStack();
    return true;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/UndoRunner.h"

#include <algorithm>

namespace espalier {

UndoRunner::UndoRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    // The timer fires when no other event waits.
    m_timer.setInterval(0);
    connect(&m_timer, &QTimer::timeout, this, &UndoRunner::advance);
}

void UndoRunner::undo()
{
    m_document.interruptEdit();
    goTo(m_document.undoStack().index() - 1);
}

void UndoRunner::redo()
{
    m_document.interruptEdit();
    goTo(m_document.undoStack().index() + 1);
}

void UndoRunner::goTo(int index)
{
    m_document.interruptEdit();
    QUndoStack& stack = m_document.undoStack();
    const int wanted = std::clamp(index, 0, stack.count());
    if (wanted == stack.index())
        return;
    const auto interrupted = [this] {
        m_timer.stop();
        m_undo.reset();
    };
    m_undo = std::make_unique<GradualUndo>(m_document, wanted, interrupted);
    m_timer.start();
    advance();
}

void UndoRunner::advance()
{
    if (m_undo->advance(m_slice))
        return;
    m_timer.stop();
    m_undo.reset();
}

void UndoRunner::finish()
{
    m_timer.stop();
    m_undo.reset();
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/GradualUndo.h"

#include "model/document/EditCommand.h"

#include <QElapsedTimer>

#include <cstdlib>

namespace espalier {

GradualUndo::GradualUndo(TreeDocument& document, int index, std::function<void()> interrupted)
    : m_document(document),
      m_index(index),
      m_edit(document,
             [this, interrupted = std::move(interrupted)] {
                 const auto told = interrupted; // a copy: the call may destroy this object
                 finish();
                 if (told)
                     told();
             }),
      m_counting(QObject::connect(&document, &TreeDocument::changed, [this](const TreeChange& change) {
          if (change.delta != nullptr)
              m_rows += 1 + change.delta->born.count + change.delta->died.size() +
                        m_document.index().recentlyMoved().size();
      }))
{
}

GradualUndo::~GradualUndo()
{
    finish();
}

bool GradualUndo::advance(std::chrono::milliseconds time, std::size_t rows)
{
    if (!m_edit.isActive())
        return false;
    if (std::exchange(m_isIndexBehind, false)) {
        m_document.prepareGrowthModel(0);
        return true;
    }
    QElapsedTimer timer;
    timer.start();
    m_rows = 0;
    do {
        if (!step()) {
            finish();
            return false;
        }
    } while (m_rows < rows || (m_rows < kMostRows && timer.elapsed() < time.count()));
    m_isIndexBehind = true;
    return true;
}

/// Reverts or applies one delta, or moves the stack past a command that is done; returns false if no delta is
/// left.
bool GradualUndo::step()
{
    QUndoStack& stack = m_document.undoStack();
    const int here = stack.index();
    if (here == m_index)
        return false;
    const bool isBack = m_index < here;
    EditCommand& command = EditCommand::at(stack, isBack ? here - 1 : here);
    if (isBack ? command.stepBack() : command.stepForward())
        return true;
    // finish() moves the stack past the last command after it has ended the edit, so that the stack's
    // listeners find no edit under way.
    if (std::abs(here - m_index) == 1)
        return false;
    if (isBack)
        stack.undo();
    else
        stack.redo();
    return true;
}

void GradualUndo::finish()
{
    if (!m_edit.isActive())
        return;
    QObject::disconnect(m_counting);
    m_edit.commit({});
    m_document.undoStack().setIndex(m_index);
}

} // namespace espalier

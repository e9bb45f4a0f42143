// SPDX-License-Identifier: GPL-3.0-or-later
// The part of MainWindow that knows what is under way, and ends it.
#include "app/MainWindow.h"
#include "model/document/Edit.h"
#include "views/Viewport.h"

namespace espalier {

/// What is under way becomes an undo step first, so that redo brings it back.
void MainWindow::undo()
{
    if (m_recipeRunner.isRunning())
        return;
    QUndoStack& stack = m_document.undoStack();
    const auto last = [&stack] { return stack.index() > 0 ? stack.command(stack.index() - 1) : nullptr; };
    const bool wasBusy = isHandBusy();
    const QUndoCommand* before = last();
    finishHand();
    if (last() == before && m_workspace->viewport().tool().canTakeBack()) {
        m_workspace->viewport().takeBackInTool();
        updateEnabled();
        return;
    }
    // A gesture that has changed nothing yet is all that there was to undo.
    if (!wasBusy || last() != before)
        m_undoRunner.undo();
}

bool MainWindow::isHandBusy() const
{
    return m_workspace->viewport().isGestureActive() || m_growRunner.isRunning() ||
           m_timeRunner.isRunning() || m_lassoRunner.isRunning();
}

bool MainWindow::isBusy() const
{
    return isHandBusy() || m_recipeRunner.isRunning();
}

bool MainWindow::makeRoom()
{
    m_recipeRunner.stop();
    finishHand();
    if (m_files->isAside())
        return m_files->mayLeaveShown();
    // A tree that is the same as when it was begun, without a file, is not worth coming back to.
    if (m_files->file().isModified() || !m_files->file().fileName().isEmpty()) {
        const Viewport& viewport = m_workspace->viewport();
        m_aside = AsideView{viewport.cameraAtRest(), viewport.clearRect(), viewport.isTreeClear()};
        m_files->setAside();
    }
    return true;
}

void MainWindow::backToOwnTree()
{
    m_recipeRunner.stop();
    finishHand();
    if (!m_files->bringBack())
        return;
    Viewport& viewport = m_workspace->viewport();
    // Bars may have come or gone meanwhile.
    if (m_aside)
        viewport.setCamera(viewport.inRoom(m_aside->camera, m_aside->clear, m_aside->showedTree));
    viewport.setFocus();
}

bool MainWindow::hasUnfinishedWork() const
{
    return m_recipeRunner.isRunning() || (m_document.edit() != nullptr && m_document.edit()->hasChanges());
}

void MainWindow::finishHand()
{
    // A lasso's stroke begins to fill when it ends.
    m_workspace->viewport().finishGesture();
    m_growRunner.end();
    m_lassoRunner.end();
    m_timeRunner.release();
    m_undoRunner.finish();
}

void MainWindow::cancelAll()
{
    m_recipeRunner.stop();
    m_workspace->viewport().cancelGesture();
    m_growRunner.cancel();
    m_lassoRunner.cancel();
    m_timeRunner.cancel();
    m_undoRunner.finish();
}

void MainWindow::cancel()
{
    // A sketch may go on while the focus is elsewhere.
    if (m_profiles->cancel() || m_files->cancelOpening() || m_another->close())
        return;
    if (isBusy()) {
        cancelAll();
        return;
    }
    // The library covers the tree and the tool, also if the focus is elsewhere.
    if (QAction* library = m_actions[ActionId::Library]; library->isChecked()) {
        library->setChecked(false);
        return;
    }
    if (m_workspace->viewport().keyForTool(Qt::Key_Escape)) {
        updateEnabled();
        return;
    }
    if (m_help->putAway())
        return;
    if (!m_document.competitors().areAll()) {
        m_document.setCompetitors({});
        return;
    }
    for (const ActionId id : Actions::sheets()) {
        if (m_actions[id]->isChecked())
            m_actions[id]->trigger();
    }
}

} // namespace espalier

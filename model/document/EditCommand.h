// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <QUndoCommand>

#include <memory>

namespace espalier {

/// The changes of an Edit as a step of the undo stack: a travel in time, the replacement of the journal's
/// end, and new deltas, each of them optional. Undo reverts and redo applies deltas; nothing is computed
/// again. Or the exchange of the whole tree with its history (TreeDocument::exchange()).
///
/// stepBack() and stepForward() undo and redo one delta at a time (see GradualUndo); undo() and redo() do all
/// that is left.
class EditCommand : public QUndoCommand {
public:
    struct Content {
        std::size_t from = 0; ///< Position in the history before the command
        std::size_t to = 0;   ///< Position that was travelled to
        Journal replaced;     ///< Deltas taken out of the journal's end at that position
        Journal deltas;       ///< Deltas applied then
        Journal future;       ///< The future that ended with the first change, its last delta first
        /// The tree that the document does not have now, if the command exchanges it; then all else is empty.
        std::shared_ptr<PreparedTree> other{};
    };

    /// Whether the document is in the state after the command already, or in the one before it.
    enum class State { Done, Undone };

    /// With State::Done all of @p content is applied already, so the first redo does nothing.
    EditCommand(TreeDocument& document, const QString& text, Content content, State state = State::Done);
    /// The command at @p index of a document's stack. (QUndoStack returns const commands, although the
    /// document may change its own.)
    static EditCommand& at(const QUndoStack& stack, int index);

    void undo() override;
    void redo() override;
    /// Reverts or applies one delta on the way to the state before the command; returns false if the document
    /// is there already. Until it is there, TreeDocument::future() is not valid.
    bool stepBack();
    /// The same on the way to the state after the command.
    bool stepForward();

    /// Whether it only travels in time. Edit::commit() merges it with an edit at the moment that it led to.
    bool isTravel() const
    {
        return !m_content.other && m_content.deltas.empty() && m_content.replaced.empty();
    }
    const Content& content() const { return m_content; }
    /// Makes the next undo() only remove the command from the stack: its deltas belong to another command
    /// from now on.
    void handOver();
    /// While it sleeps, undo() and redo() do nothing, so that a stack can be filled with commands of a
    /// document that is in their state already.
    void setAsleep(bool asleep) { m_isAsleep = asleep; }

private:
    bool travelOneTowards(std::size_t position);
    /// Exchanges the trees if the document does not have the one after (@p forward) or before the command.
    bool exchangeTowards(bool forward);

    TreeDocument& m_document;
    Content m_content;
    std::size_t m_applied;  ///< Number of content().deltas that are applied, counted from the first
    std::size_t m_takenOut; ///< Number of content().replaced out of the journal, counted from the last
    bool m_isHandedOver = false;
    bool m_isAsleep = false;
    bool m_isExchanged; ///< The document has the tree after the command
};

} // namespace espalier

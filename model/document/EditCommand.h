// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <QUndoCommand>

namespace espalier {

/// What an Edit did, as a step of the undo stack: a travel in time, the replacement of the journal's end, and
/// new deltas, each of them optional. It was computed once: undo reverts and redo applies.
///
/// stepBack() and stepForward() undo and redo one delta at a time; undo() and redo() do what is left of that
/// (see GradualUndo).
class EditCommand : public QUndoCommand {
public:
    struct Content {
        std::size_t from = 0; ///< Position in the history before
        std::size_t to = 0;   ///< Position that was travelled to
        Journal replaced;     ///< Taken out of the journal's end there
        Journal deltas;       ///< Applied then
        Journal future;       ///< That the first delta ended, the last of it first
    };

    /// All of it stands applied: the first redo does nothing.
    EditCommand(TreeDocument& document, const QString& text, Content content);
    /// The command at @p index of a document's stack. (QUndoStack gives its commands as const; these are the
    /// document's.)
    static EditCommand& at(const QUndoStack& stack, int index);

    void undo() override;
    void redo() override;
    /// Reverts or applies one delta on the way to the state before the command; returns false if the document
    /// was there already. Until it is there, its future is not valid.
    bool stepBack();
    /// The same on the way to the state after the command.
    bool stepForward();

    /// Whether it does nothing but travel in time: what is done at the moment that it led to joins it.
    bool isTravel() const { return m_content.deltas.empty() && m_content.replaced.empty(); }
    const Content& content() const { return m_content; }
    /// The next undo only takes the command off the stack: what it did belongs to another command from now
    /// on.
    void handOver();

private:
    bool travelOneTowards(std::size_t position);

    TreeDocument& m_document;
    Content m_content;
    std::size_t m_applied;  ///< The first of content().deltas, so many, stand applied
    std::size_t m_takenOut; ///< The last of content().replaced, so many, are out of the journal
    bool m_isHandedOver = false;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <functional>
#include <memory>

namespace espalier {

/// The right to change a document, from the first preview of a change to its end as one undo step. A document
/// has at most one edit at a time. Gestures, tools, runners and players change the tree only through an Edit.
///
/// Applied deltas show at once. commit() makes all of them one command whose first redo does nothing.
/// cancel() takes them back and leaves no trace: tree, journal, future and undo stack are, byte for byte, as
/// before. The destructor cancels an edit that has not ended.
class Edit {
public:
    /// Called when another edit begins, or before the document is saved, replaced or closed. It must end this
    /// edit, usually with commit(), which keeps the changes; otherwise the document cancels the edit.
    using Interrupted = std::function<void()>;

    enum class Kind {
        Change,
        ParameterTrial, ///< Work that waits for such trials goes on waiting; see
                        ///< TreeDocument::setPausedWork()
    };

    /// Begins, after interrupting the edit that is under way. If @p interrupted is empty, an interruption
    /// cancels this edit. Precondition: no listener of TreeDocument::changed() is being called.
    explicit Edit(TreeDocument& document, Interrupted interrupted = {}, Kind kind = Kind::Change);
    /// Continues the last command of the undo stack: the command leaves the stack, and its deltas count as
    /// applied by this edit. Precondition: the document's last change was the commit of that command.
    static std::unique_ptr<Edit> resumed(TreeDocument& document, Kind kind = Kind::Change);
    ~Edit();
    Edit(const Edit&) = delete;
    Edit& operator=(const Edit&) = delete;

    TreeDocument& document() const { return m_document; }
    /// Whether the edit has been neither committed nor cancelled.
    bool isActive() const { return !m_hasEnded; }
    /// The number of deltas that this edit has applied and not taken back.
    std::size_t deltaCount() const { return m_deltas.size(); }
    bool hasChanges() const { return !m_deltas.empty() || !m_replaced.empty() || m_to != m_from; }

    /// Applies @p delta, which starts at the present state of the tree, after the deltas of this edit. An
    /// empty delta is ignored. If the document shows an earlier moment, its future ends; undo and cancel()
    /// restore it.
    void apply(TreeDelta delta);
    /// Reverts the deltas that this edit has applied, so that another preview can replace them.
    void takeBack();
    /// Calls takeBack(), then apply(): @p delta starts at the tree before this edit.
    void show(TreeDelta delta);
    /// Reverts the last delta that this edit has applied.
    void takeBackLast();
    /// Reverts the journal's deltas from @p position on; what is applied next replaces them. Precondition:
    /// no delta of this edit is applied, nothing was replaced yet, and position <= journal().size().
    void replaceFrom(std::size_t position);
    /// Travels to the moment after the first @p position deltas of the history. Precondition: no delta of
    /// this edit is applied, nothing was replaced, and position <= journal().size() + future().size().
    void travelTo(std::size_t position);

    /// Ends the edit and makes its changes one undo step named @p text; none if nothing has changed.
    /// @p operation: the recipe's operation that does the same, as compact JSON (EditRecord), or empty.
    void commit(const QString& text, const QByteArray& operation = {});
    /// Ends the edit and restores the state before it.
    void cancel();

private:
    friend class TreeDocument;

    void end();
    void record(const QByteArray& operation);

    TreeDocument& m_document;
    Interrupted m_interrupted;
    std::size_t m_from; ///< Position in the journal when the edit began
    std::size_t m_to;   ///< Position that it travelled to
    Journal m_replaced; ///< Deltas that replaceFrom() has reverted, in the journal's order
    Journal m_deltas;   ///< Deltas applied, first to last
    Journal m_future;   ///< The future that ended with the first change
    bool m_hasEnded = false;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <functional>
#include <memory>

namespace espalier {

/// The right to change a document, from the first preview of a change to its end as one undo step. A document
/// has at most one at a time: gestures, tools, runners and players all change the tree through an Edit and
/// through nothing else.
///
/// What is applied shows at once. commit() makes all of it one command whose first redo does nothing;
/// cancel() takes it back and leaves no trace: tree, journal, future and undo stack are, byte for byte, those
/// of before. An edit that is destroyed unfinished is cancelled.
class Edit {
public:
    /// What the owner does when another edit is asked for, or the document is saved, replaced or closed: it
    /// must end this edit, and usually keeps what was done (commit()).
    using Interrupted = std::function<void()>;

    /// Begins. An edit that is under way is interrupted first. Without @p interrupted, this one is cancelled
    /// then.
    explicit Edit(TreeDocument& document, Interrupted interrupted = {});
    /// Goes on with the last command of the undo stack, which leaves the stack; its deltas stand applied by
    /// this edit. Precondition: the document's last change was the commit of that command.
    static std::unique_ptr<Edit> resumed(TreeDocument& document);
    ~Edit();
    Edit(const Edit&) = delete;
    Edit& operator=(const Edit&) = delete;

    TreeDocument& document() const { return m_document; }
    /// Whether it has neither been committed nor cancelled.
    bool isActive() const { return !m_hasEnded; }
    /// Deltas that stand applied by this edit.
    std::size_t deltaCount() const { return m_deltas.size(); }
    bool hasChanges() const { return !m_deltas.empty() || !m_replaced.empty() || m_to != m_from; }

    /// Applies @p delta, which starts at the tree as it is, on top of what this edit has done. An empty one
    /// is left out. If time was turned back, the future ends here; undo and cancel() bring it back.
    void apply(TreeDelta delta);
    /// Takes back what this edit has applied, so that another preview can take its place.
    void takeBack();
    /// takeBack() and apply(): @p delta starts at the tree before this edit.
    void show(TreeDelta delta);
    /// Takes back the last delta that this edit has applied.
    void takeBackLast();
    /// Takes the journal's end, from @p position on, out of the tree: what is applied next stands in its
    /// place. Precondition: nothing was applied yet, and position <= journal().size().
    void replaceFrom(std::size_t position);
    /// Goes to where @p position deltas of the history have been applied. Precondition: nothing stands
    /// applied, and position <= journal().size() + future().size().
    void travelTo(std::size_t position);

    /// Ends. Makes what was done one undo step, named @p text; none if nothing was done. @p operation is the
    /// recipe's operation that does the same, as compact JSON (EditRecord); empty if there is none.
    void commit(const QString& text, const QByteArray& operation = {});
    void cancel();

private:
    friend class TreeDocument;

    void end();
    void record(const QByteArray& operation);

    TreeDocument& m_document;
    Interrupted m_interrupted;
    std::size_t m_from; ///< Position in the journal when the edit began
    std::size_t m_to;   ///< Where it travelled to
    Journal m_replaced; ///< In the journal's order
    Journal m_deltas;   ///< Applied, first to last
    Journal m_future;   ///< That ended with the first delta
    bool m_hasEnded = false;
};

} // namespace espalier

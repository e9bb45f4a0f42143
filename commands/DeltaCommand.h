// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <QUndoCommand>

#include <memory>

namespace espalier {

/// Of commands that merge (QUndoCommand::id).
inline constexpr int kTimeTravelId = 1;

/// A command that was computed once and is kept as deltas: undo reverts them, redo applies them, nothing is
/// computed again. Its deltas stand applied when it is pushed (a gesture previews by applying them), so its
/// first redo does nothing. What was ahead of it, if time had been turned back, it takes away, and brings
/// back on undo.
class DeltaCommand : public QUndoCommand {
public:
    /// @param replacedDeltas what was taken out of the end of the journal before, in the journal's order
    DeltaCommand(TreeDocument& document, QString text, Journal appliedDeltas, Journal replacedDeltas = {});

    void undo() override;
    void redo() override;
    /// Lets a TimeTravelCommand take it in, if a future was lost by it.
    int id() const override;
    /// The same command, for whom it merges with.
    std::unique_ptr<DeltaCommand> copy() const;

private:
    DeltaCommand(const DeltaCommand& other);

    TreeDocument& m_document;
    Journal m_deltas;
    Journal m_replaced;
    Journal m_lost; ///< The future before
    bool m_applied = true;
};

/// Reverts the last @p deltas of the document's journal.
void revertAll(TreeDocument& document, const Journal& deltas);
void applyAll(TreeDocument& document, const Journal& deltas);

} // namespace espalier

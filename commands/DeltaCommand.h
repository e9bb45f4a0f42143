// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

#include <QUndoCommand>

namespace espalier {

/// A command that was computed once and is kept as deltas: undo reverts them, redo applies them, nothing is
/// computed again. Its deltas stand applied when it is pushed (a gesture previews by applying them), so its
/// first redo does nothing.
class DeltaCommand : public QUndoCommand {
public:
    DeltaCommand(TreeDocument& document, QString text, Journal appliedDeltas);

    void undo() override;
    void redo() override;

private:
    TreeDocument& m_document;
    Journal m_deltas;
    bool m_applied = true;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/GradualUndo.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Undoes and redoes for a window: a command that changes few rows at once, a large one in slices between
/// which the window draws and listens. Code that changes the document
/// meanwhile finds all of it done.
class UndoRunner : public QObject {
    Q_OBJECT

public:
    explicit UndoRunner(TreeDocument& document, QObject* parent = nullptr);

    /// Time that a slice takes at least, if so much is left; with the delta that it ends with, it stays below
    /// 16 ms for trees of 100,000 internodes. 0 makes the slices as short as GradualUndo allows.
    void setSlice(std::chrono::milliseconds slice) { m_slice = slice; }
    /// Finish what is under way first.
    void undo();
    void redo();
    /// Goes to where @p index commands of the stack are done, 0...count().
    void goTo(int index);
    /// Does at once what is left.
    void finish();
    bool isRunning() const { return m_undo != nullptr; }

private:
    void advance();

    TreeDocument& m_document;
    std::unique_ptr<GradualUndo> m_undo;
    std::chrono::milliseconds m_slice{6};
    QTimer m_timer;
};

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/GradualUndo.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Undoes and redoes for a window: a command that changes few rows at once, a large one in slices, between
/// which the window draws and handles events. Code that changes the document meanwhile makes it do the rest
/// first.
class UndoRunner : public QObject {
    Q_OBJECT

public:
    explicit UndoRunner(TreeDocument& document, QObject* parent = nullptr);

    /// The least time of a slice, unless less is left. With the delta that it ends with, a slice stays below
    /// 16 ms for trees of 100,000 internodes. 0 makes slices as short as GradualUndo allows.
    void setSlice(std::chrono::milliseconds slice) { m_slice = slice; }
    /// Undo or redo one command. An edit, undo or redo that is under way is completed first.
    void undo();
    void redo();
    /// Goes to the state in which the first @p index commands of the stack are done; clamped to 0...count().
    void goTo(int index);
    /// Does the rest at once.
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

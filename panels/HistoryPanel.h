// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"

class QUndoStack;
class QUndoView;

namespace espalier {

/// The list of all edits and growth steps; a click on a row goes to that step.
class HistoryPanel : public Bar {
    Q_OBJECT

public:
    explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {220, 360}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QUndoView* m_list;
};

} // namespace espalier

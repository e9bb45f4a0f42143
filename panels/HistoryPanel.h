// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"

class QUndoStack;
class QUndoView;

namespace espalier {

/// All that was done, step by step; a click asks for that step.
class HistoryPanel : public Bar {
    Q_OBJECT

public:
    explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {220, 360}; }

Q_SIGNALS:
    /// The tree as it was when @p index commands of the stack were done is wanted.
    void indexAsked(int index);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QUndoView* m_list;
};

} // namespace espalier

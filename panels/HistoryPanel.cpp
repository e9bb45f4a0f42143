// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HistoryPanel.h"

#include "panels/Theme.h"

#include <QLabel>
#include <QUndoView>
#include <QVBoxLayout>

namespace espalier {

HistoryPanel::HistoryPanel(QUndoStack& stack, QWidget* parent) : Bar(parent)
{
    auto* title = new QLabel(tr("History"), this);
    auto* list = new QUndoView(&stack, this);
    list->setObjectName(QStringLiteral("history"));
    list->setAccessibleName(tr("History"));
    list->setEmptyLabel(tr("Seedling"));
    list->setFrameShape(QFrame::NoFrame);
    list->setUniformItemSizes(true);
    list->setStyleSheet(QStringLiteral("QListView::item { min-height: %1px; }").arg(theme::kTarget));
    title->setBuddy(list);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 12);
    column->setSpacing(6);
    column->addWidget(title);
    column->addWidget(list, 1);
}

} // namespace espalier

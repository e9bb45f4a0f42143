// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HistoryPanel.h"

#include "panels/Theme.h"

#include <QItemSelectionModel>
#include <QLabel>
#include <QUndoStack>
#include <QUndoView>
#include <QVBoxLayout>

namespace espalier {

HistoryPanel::HistoryPanel(QUndoStack& stack, QWidget* parent)
    : Bar(parent), m_list(new QUndoView(&stack, this))
{
    auto* title = new QLabel(tr("History"), this);
    m_list->setObjectName(QStringLiteral("history"));
    m_list->setAccessibleName(tr("History"));
    m_list->setEmptyLabel(tr("Seedling"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setUniformItemSizes(true);
    m_list->setStyleSheet(QStringLiteral("QListView::item { min-height: %1px; }").arg(theme::kTarget));
    // The list would take the stack there in one event, however much there is to undo.
    const QItemSelectionModel* selection = m_list->selectionModel();
    disconnect(selection, &QItemSelectionModel::currentChanged, m_list->model(), nullptr);
    connect(selection, &QItemSelectionModel::currentChanged, this,
            [this, &stack](const QModelIndex& current) {
                if (current.isValid() && current.row() != stack.index())
                    Q_EMIT indexAsked(current.row());
            });
    title->setBuddy(m_list);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 12);
    column->setSpacing(6);
    column->addWidget(title);
    column->addWidget(m_list, 1);
}

void HistoryPanel::resizeEvent(QResizeEvent* event)
{
    Bar::resizeEvent(event);
    // Keeps the current step visible.
    layout()->activate();
    m_list->scrollTo(m_list->currentIndex());
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/SheetScroll.h"

#include "panels/Theme.h"

#include <QLabel>
#include <QScrollBar>
#include <QWheelEvent>

namespace espalier {

namespace {

/// Room for the scroll bar below the rows, px.
constexpr int kScrollBarHeight = 6;

} // namespace

QLabel* sheetTitle(const QString& text, QWidget* parent)
{
    auto* title = new QLabel(text, parent);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    // For all states: a panel that rests during a stroke shall not flicker.
    QPalette bright = title->palette();
    bright.setColor(QPalette::WindowText, theme::kText);
    title->setPalette(bright);
    title->setFixedHeight(24);
    title->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return title;
}

SheetScroll::SheetScroll(QWidget* content, QWidget* parent) : QScrollArea(parent)
{
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setWidgetResizable(true);
    setWidget(content);
}

QSize SheetScroll::sizeHint() const
{
    return widget()->sizeHint() + QSize(0, kScrollBarHeight);
}

void SheetScroll::wheelEvent(QWheelEvent* event)
{
    const QPoint turned = event->angleDelta();
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() -
                                    (turned.y() != 0 ? turned.y() : turned.x()));
    event->accept();
}

} // namespace espalier

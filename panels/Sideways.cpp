// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Sideways.h"

#include <QMouseEvent>
#include <QScrollBar>
#include <QWheelEvent>

namespace espalier {

namespace {

/// Room for the scroll bar below the contents.
constexpr int kScrollBarHeight = 8;

} // namespace

Sideways::Sideways(QWidget* content, QWidget* parent) : QScrollArea(parent)
{
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setWidgetResizable(true);
    setWidget(content);
}

QSize Sideways::sizeHint() const
{
    return widget()->sizeHint() + QSize(0, kScrollBarHeight);
}

void Sideways::wheelEvent(QWheelEvent* event)
{
    const QPoint turned = event->angleDelta();
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() -
                                    (turned.y() != 0 ? turned.y() : turned.x()));
    event->accept();
}

void Sideways::mousePressEvent(QMouseEvent* event)
{
    m_pressX = event->globalPosition().x();
    m_pressPlace = horizontalScrollBar()->value();
    event->accept();
}

void Sideways::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        horizontalScrollBar()->setValue(m_pressPlace -
                                        static_cast<int>(event->globalPosition().x() - m_pressX));
}

} // namespace espalier

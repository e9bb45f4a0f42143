// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Bar.h"

#include "panels/Theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QFrame>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>

namespace espalier {

Bar::Bar(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_NoMousePropagation);
    setCursor(Qt::ArrowCursor);
}

void Bar::setFlat(bool flat)
{
    m_flat = flat;
    update();
}

void Bar::setOpaque(bool opaque)
{
    m_isOpaque = opaque;
    update();
}

bool Bar::event(QEvent* event)
{
    // Within a bar the Tab key moves to the next control, also if it has a meaning for the tree.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Tab || key == Qt::Key_Backtab) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void Bar::keyPressEvent(QKeyEvent* event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    auto* button = isEnter ? qobject_cast<QAbstractButton*>(QApplication::focusWidget()) : nullptr;
    if (button && isAncestorOf(button))
        button->animateClick();
    else
        QWidget::keyPressEvent(event);
}

void Bar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (m_flat) {
        painter.fillRect(rect(), theme::kBar);
        painter.fillRect(0, height() - 1, width(), 1, theme::kEdge);
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme::kEdge, 1.0));
    painter.setBrush(m_isOpaque ? theme::kRaised : theme::kBar);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme::kRadius, theme::kRadius);
}

BarButton::BarButton(Look look, QWidget* parent) : QToolButton(parent), m_look(look)
{
    setAutoRaise(true);
    setIconSize({24, 24});
    // A click must not take the keyboard focus from the tree; Tab still reaches the button.
    setFocusPolicy(Qt::TabFocus);
    switch (look) {
    case Look::Icon:
        setToolButtonStyle(Qt::ToolButtonIconOnly);
        setProperty("look", "icon");
        break;
    case Look::IconAboveText: {
        setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        setProperty("look", "tool");
        QFont small = font();
        small.setPointSizeF(small.pointSizeF() * 0.88);
        setFont(small);
        break;
    }
    case Look::Tab:
        setToolButtonStyle(Qt::ToolButtonTextOnly);
        setProperty("look", "tab");
        break;
    }
}

BarButton::BarButton(Look look, QAction* action, QWidget* parent) : BarButton(look, parent)
{
    setDefaultAction(action);
}

QSize BarButton::sizeHint() const
{
    switch (m_look) {
    case Look::IconAboveText:
        return {66, 56};
    case Look::Tab:
        return {fontMetrics().horizontalAdvance(text()) * 108 / 100 + 28, theme::kTarget};
    default:
        return {theme::kTarget, theme::kTarget};
    }
}

QWidget* barSeparator(Qt::Orientation orientation, QWidget* parent)
{
    auto* line = new QFrame(parent);
    line->setFrameShape(QFrame::NoFrame);
    line->setProperty("separator", true);
    if (orientation == Qt::Horizontal)
        line->setFixedHeight(1);
    else
        line->setFixedWidth(1);
    return line;
}

QLabel* barHeading(const QString& text, QWidget* parent)
{
    auto* title = new QLabel(text, parent);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    // The colour is the same in all states, so that a panel that is disabled during a stroke does not
    // flicker.
    theme::setTone(*title, theme::Tone::Bright);
    title->setFixedHeight(24);
    title->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return title;
}

QVBoxLayout* addBarColumn(QWidget& content, const QString& title, int width)
{
    auto* columns = static_cast<QHBoxLayout*>(content.layout());
    if (columns->count() > 0)
        columns->addWidget(barSeparator(Qt::Vertical, &content));
    auto* box = new QWidget(&content);
    box->setFixedWidth(width);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(barHeading(title, box));
    columns->addWidget(box);
    return column;
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/Diagram.h"

#include "panels/ParameterValue.h"
#include "panels/Theme.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr double kHandleRadius = 8.0;
/// Movement below which a press is not a drag, px.
constexpr double kTremble = 3.0;

double length(const QPointF& vector)
{
    return std::hypot(vector.x(), vector.y());
}

} // namespace

Diagram::Diagram(ParameterEditor& editor, QWidget* parent) : QWidget(parent), m_editor(editor)
{
    setMouseTracking(true);
    connect(&editor, &ParameterEditor::overtaken, this, &Diagram::letGo);
    connect(&editor, &ParameterEditor::shownChanged, this, &Diagram::follow);
}

Diagram::~Diagram() = default;

void Diagram::addHandle(std::vector<const char*> keys, const QString& name)
{
    const QString own = name.isEmpty() ? parameterTr(parameterText(keys.front())->label) : name;
    m_handles.push_back(new DiagramHandle(*this, *this, handleCount(), std::move(keys), own));
}

QPointF Diagram::handlePlace(int number) const
{
    return place(number, shown());
}

int Diagram::handleAt(const QPointF& point) const
{
    int nearest = -1;
    double least = kReach;
    for (int i = 0; i < handleCount(); ++i) {
        const double distance = length(point - handlePlace(i));
        // Of handles at the same place, the one drawn last is on top.
        if (distance <= least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

void Diagram::follow()
{
    for (int i = 0; i < handleCount(); ++i) {
        const QPoint centre = handlePlace(i).toPoint();
        const int reach = static_cast<int>(kReach);
        handle(i).setGeometry(centre.x() - reach, centre.y() - reach, 2 * reach, 2 * reach);
        handle(i).announce();
    }
    update();
}

void Diagram::stride(int number, const QPointF& direction, ParameterScale::Stride stride,
                     TreeParameters& parameters) const
{
    // The direction in which the handle moves when its value grows decides which arrow keys raise it.
    const ParameterScale& scale = handle(number).scale();
    const char* key = scale.info().key;
    const double value = handle(number).value();
    const double span = scale.info().maximum - scale.info().minimum;
    TreeParameters more = parameters;
    const bool isFull = value + 0.01 * span > scale.info().maximum;
    setParameter(more, key, value + (isFull ? -0.01 : 0.01) * span);
    QPointF way = place(number, more.growth) - place(number, parameters.growth);
    if (isFull)
        way = -way;
    const double along = QPointF::dotProduct(way, direction);
    if (std::abs(along) < 0.25 * length(way))
        return;
    setParameter(parameters, key, scale.stepped(value, along > 0.0 ? 1 : -1, stride));
}

QString Diagram::bubbleText(int number) const
{
    return handle(number).valueText();
}

void Diagram::reset(int number)
{
    m_editor.reset(handle(number).keys(), handle(number).accessibleName());
}

void Diagram::setValueOf(const DiagramHandle& handle, const char* key, double value)
{
    m_editor.nudge(&handle, key, value, handle.accessibleName());
}

void Diagram::moveHandle(const DiagramHandle& handle, const QPointF& direction, ParameterScale::Stride stride)
{
    TreeParameters parameters = m_editor.shown();
    this->stride(handle.number(), direction, stride, parameters);
    m_editor.nudge(&handle, parameters, handle.accessibleName());
}

void Diagram::resetHandle(const DiagramHandle& handle)
{
    m_editor.begin();
    reset(handle.number());
}

void Diagram::letGo()
{
    m_dragged = -1;
    m_moved = false;
    m_atPress.reset();
}

void Diagram::drop()
{
    letGo();
    m_editor.cancel();
}

bool Diagram::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int number = handleAt(help->pos());
        QToolTip::showText(help->globalPos(), number >= 0 ? handle(number).toolTip() : toolTip(), this);
        return true;
    }
    return QWidget::event(event);
}

void Diagram::changeEvent(QEvent* event)
{
    // Another edit of the document begins.
    if (event->type() == QEvent::EnabledChange && !isEnabled() && isDragging())
        drop();
    QWidget::changeEvent(event);
}

void Diagram::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    follow();
}

void Diagram::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    m_hovered = -1;
    update();
}

void Diagram::mousePressEvent(QMouseEvent* event)
{
    const int number = event->button() == Qt::LeftButton ? handleAt(event->position()) : -1;
    m_editor.begin();
    if (number < 0) {
        event->ignore();
        return;
    }
    m_dragged = number;
    m_moved = false;
    m_press = event->position();
    m_atPress = m_editor.shown();
    handle(number).setFocus(Qt::MouseFocusReason);
    update();
}

void Diagram::mouseMoveEvent(QMouseEvent* event)
{
    if (!isDragging()) {
        const int hovered = event->buttons() == Qt::NoButton ? handleAt(event->position()) : -1;
        if (std::exchange(m_hovered, hovered) != hovered) {
            setCursor(hovered >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
            update();
        }
        event->ignore();
        return;
    }
    if (!m_moved) {
        if (length(event->position() - m_press) < kTremble)
            return;
        m_moved = true;
        m_grip = place(m_dragged, m_atPress->growth) - m_press;
    }
    TreeParameters parameters = *m_atPress;
    pull(m_dragged, event->position() + m_grip, parameters);
    m_editor.show(parameters);
}

void Diagram::mouseReleaseEvent(QMouseEvent* event)
{
    if (!isDragging() || event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    const int number = std::exchange(m_dragged, -1);
    m_atPress.reset();
    if (std::exchange(m_moved, false))
        m_editor.finish(handle(number).accessibleName());
    follow();
}

void Diagram::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const int number = handleAt(event->position()); number >= 0) {
        reset(number);
        return;
    }
    std::vector<const char*> keys;
    for (const DiagramHandle* one : m_handles)
        keys.insert(keys.end(), one->keys().begin(), one->keys().end());
    m_editor.reset(keys, accessibleName());
}

void Diagram::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter, shown());
    for (int i = 0; i < handleCount(); ++i)
        drawHandle(painter, i);
    for (int i = 0; i < handleCount(); ++i) {
        if (i == m_dragged || (!isDragging() && i == m_hovered))
            drawBubble(painter, i);
    }
}

void Diagram::drawHandle(QPainter& painter, int number) const
{
    const QPointF centre = handlePlace(number);
    const bool isGrasped = number == m_dragged;
    const bool isHovered = number == m_hovered && !isDragging();
    const bool isFocused = handle(number).hasFocus();
    // The colour does not change while the panel is disabled during a stroke, so that it does not flicker.
    QColor colour = theme::kHandle;
    if (isGrasped || isHovered) {
        QColor halo = colour;
        halo.setAlpha(isGrasped ? 70 : 45);
        painter.setPen(Qt::NoPen);
        painter.setBrush(halo);
        painter.drawEllipse(centre, kHandleRadius + 8.0, kHandleRadius + 8.0);
        colour = colour.lighter(112);
    }
    // A dark rim separates the handle from the drawing.
    const QColor rim(0x1d, 0x20, 0x26, 200);
    painter.setBrush(Qt::NoBrush);
    if (isRing(number)) {
        painter.setPen(QPen(rim, 7.0));
        painter.drawEllipse(centre, kHandleRadius - 1.0, kHandleRadius - 1.0);
        painter.setPen(QPen(colour, 3.5));
        painter.drawEllipse(centre, kHandleRadius - 1.0, kHandleRadius - 1.0);
    } else {
        painter.setPen(QPen(rim, 2.0));
        painter.setBrush(colour);
        painter.drawEllipse(centre, kHandleRadius, kHandleRadius);
    }
    if (isFocused) {
        painter.setPen(QPen(theme::kBrightText, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, kHandleRadius + 2.5, kHandleRadius + 2.5);
    }
}

void Diagram::drawBubble(QPainter& painter, int number) const
{
    const QString text = bubbleText(number);
    if (text.isEmpty())
        return;
    const QSizeF size(painter.fontMetrics().horizontalAdvance(text) + 14.0,
                      painter.fontMetrics().height() + 6.0);
    const QPointF handle = handlePlace(number);
    // Above the finger; at the upper edge below it.
    double top = handle.y() - kHandleRadius - 8.0 - size.height();
    if (top < 1.0)
        top = handle.y() + kHandleRadius + 8.0;
    top = std::clamp(top, 1.0, height() - size.height() - 1.0);
    const double left = std::clamp(handle.x() - size.width() / 2.0, 1.0, width() - size.width() - 1.0);
    const QRectF box(QPointF(left, top), size);
    painter.setPen(QPen(theme::kBubbleEdge, 1.0));
    painter.setBrush(theme::kBubble);
    painter.drawRoundedRect(box, 6.0, 6.0);
    painter.setPen(theme::kBubbleText);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace espalier

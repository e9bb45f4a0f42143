// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/FineSlider.h"

#include <QMouseEvent>

#include <cmath>

namespace espalier {

void FineSlider::mousePressEvent(QMouseEvent* event)
{
    m_drag.begin(event->position().x(), event->position().x());
    QSlider::mousePressEvent(event);
}

void FineSlider::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF pointer = event->position();
    m_drag.move(pointer.x(), std::abs(pointer.y() - height() / 2.0),
                event->modifiers().testFlag(Qt::ShiftModifier));
    const QPointF place(m_drag.place(), pointer.y());
    QMouseEvent led(event->type(), place, mapToGlobal(place), event->button(), event->buttons(),
                    event->modifiers(), event->pointingDevice());
    QSlider::mouseMoveEvent(&led);
    event->setAccepted(led.isAccepted());
}

} // namespace espalier

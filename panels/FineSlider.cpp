// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/FineSlider.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace espalier {

void FineSlider::mousePressEvent(QMouseEvent* event)
{
    const double x = event->position().x();
    m_drag.begin(x, x, std::min(x, 0.0), std::max<double>(x, width()));
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

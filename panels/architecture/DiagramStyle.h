// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Theme.h"

#include <QPainter>

#include <cmath>

/// Colours and shapes that all diagrams of architecture use.
namespace espalier::diagram {

inline constexpr QColor kWood(0xa8, 0x8a, 0x70);
inline constexpr QColor kFill(0x7f, 0xb0, 0x69, 0x38); ///< Inside a green outline
/// Axes, and the form that a tree has without the setting.
inline constexpr QColor kGuide(0x9a, 0xa2, 0xae, 0x60);
inline constexpr QColor kRed(0xc9, 0x6a, 0x62); ///< Gravity; occupied space

/// A point at @p length px from @p origin, turned by @p angle (rad) from straight up to the right.
inline QPointF polar(const QPointF& origin, double length, double angle)
{
    return origin + QPointF(length * std::sin(angle), -length * std::cos(angle));
}

/// The angle of @p point seen from @p origin, rad, −π...π; the reverse of polar().
inline double angleOf(const QPointF& origin, const QPointF& point)
{
    return std::atan2(point.x() - origin.x(), origin.y() - point.y());
}

inline double distance(const QPointF& from, const QPointF& to)
{
    return std::hypot(to.x() - from.x(), to.y() - from.y());
}

/// The value of a drag of @p pixels in a direction where the drawing has @p room px: beyond the drawing's
/// edge the value rises faster, because there is little room to drag.
inline double stretched(double pixels, double room)
{
    const double part = std::abs(pixels) / room;
    return part <= 1.0 ? pixels : pixels * part * part;
}

/// An arc from @p from to @p to (rad, as in polar()).
inline void drawArc(QPainter& painter, const QPointF& centre, double radius, double from, double to)
{
    const QRectF box(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius);
    const auto sixteenths = [](double angle) {
        return static_cast<int>(std::lround(16.0 * angle * 180.0 / 3.14159265358979));
    };
    // Qt's angles count counterclockwise from the right.
    painter.drawArc(box, 90 * 16 - sixteenths(from), -sixteenths(to - from));
}

inline QPen guidePen()
{
    return {kGuide, 1.0, Qt::DotLine};
}

/// A small label beside a point.
inline void drawLabel(QPainter& painter, const QPointF& centre, const QString& text,
                      const QColor& colour = theme::kDimText)
{
    QRectF box(QPointF(), QSizeF(painter.fontMetrics().size(Qt::TextSingleLine, text)) + QSizeF(2.0, 0.0));
    box.moveCenter(centre);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace espalier::diagram

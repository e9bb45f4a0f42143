// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/RadiusSlider.h"

#include "model/settings/Lengths.h"
#include "panels/Theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

constexpr int kRadiusSteps = 600;
constexpr double kSliderHandleRadius = 12.0;
constexpr double kTopWidth = 30.0;
constexpr double kBottomWidth = 7.0;

} // namespace

RadiusSlider::RadiusSlider(double maximum, QWidget* parent) : QAbstractSlider(parent), m_maximum(maximum)
{
    setOrientation(Qt::Vertical);
    setRange(0, kRadiusSteps);
    setSingleStep(kRadiusSteps / 60);
    setPageStep(kRadiusSteps / 12);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    setAccessibleName(tr("Brush radius"));
}

void RadiusSlider::setMaximumRadius(double metres)
{
    if (std::exchange(m_maximum, metres) != metres)
        showRadius(m_radius);
}

void RadiusSlider::setRadius(double metres)
{
    if (metres != m_radius)
        showRadius(metres);
}

void RadiusSlider::showRadius(double metres)
{
    const QSignalBlocker quiet(this);
    setValue(static_cast<int>(std::lround(std::cbrt(std::min(metres / m_maximum, 1.0)) * kRadiusSteps)));
    m_radius = metres;
    update();
}

void RadiusSlider::sliderChange(SliderChange change)
{
    if (change == SliderValueChange) {
        const double t = value() / static_cast<double>(kRadiusSteps);
        m_radius = std::min(roundedLength(m_maximum * t * t * t), m_maximum);
        if (!signalsBlocked())
            Q_EMIT radiusEdited(m_radius);
    }
    QAbstractSlider::sliderChange(change);
    update();
}

double RadiusSlider::yOf(int position) const
{
    const double reach = height() - 2.0 * kSliderHandleRadius - 2.0;
    return 1.0 + kSliderHandleRadius + reach * (1.0 - position / static_cast<double>(kRadiusSteps));
}

void RadiusSlider::dragTo(double y)
{
    const double reach = height() - 2.0 * kSliderHandleRadius - 2.0;
    const double t = std::clamp(1.0 - (y - 1.0 - kSliderHandleRadius) / reach, 0.0, 1.0);
    setValue(static_cast<int>(std::lround(t * kRadiusSteps)));
}

void RadiusSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = width() / 2.0;
    const double top = yOf(kRadiusSteps);
    const double bottom = yOf(0);
    const double y = yOf(value());
    const auto halfWidthAt = [&](double at) {
        return (kTopWidth + (kBottomWidth - kTopWidth) * (at - top) / (bottom - top)) / 2.0;
    };
    const auto wedge = [&](double from, double to) {
        QPainterPath path;
        path.moveTo(middle - halfWidthAt(from), from);
        path.lineTo(middle + halfWidthAt(from), from);
        path.lineTo(middle + halfWidthAt(to), to);
        path.lineTo(middle - halfWidthAt(to), to);
        path.closeSubpath();
        return path;
    };
    // The stroke in the fill's colour gives the wedge round corners.
    const auto fill = [&](const QPainterPath& path, const QColor& colour) {
        painter.setPen(QPen(colour, 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(colour);
        painter.drawPath(path);
    };
    fill(wedge(top, bottom), theme::kSunken);
    const QColor filled = isEnabled() ? theme::kHandleFill : theme::kFaintText;
    if (y < bottom - 1.0)
        fill(wedge(y, bottom), filled);

    painter.setPen(hasFocus() ? QPen(theme::kAccent, 2.0) : QPen(QColor(0, 0, 0, 70), 1.0));
    painter.setBrush(underMouse() || isSliderDown() ? theme::kHandle.lighter(112) : theme::kHandle);
    painter.drawEllipse(QPointF(middle, y), kSliderHandleRadius - 0.5, kSliderHandleRadius - 0.5);
}

void RadiusSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    setSliderDown(true);
    m_drag.begin(event->position().y(), event->position().y(), 0.0, height());
    dragTo(m_drag.place());
}

void RadiusSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (!isSliderDown())
        return;
    m_drag.move(event->position().y(), std::abs(event->position().x() - width() / 2.0),
                event->modifiers().testFlag(Qt::ShiftModifier));
    dragTo(m_drag.place());
}

void RadiusSlider::mouseReleaseEvent(QMouseEvent*)
{
    setSliderDown(false);
    update();
}

} // namespace espalier

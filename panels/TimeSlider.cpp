// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/TimeSlider.h"

#include "panels/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

constexpr double kKnobRadius = 8.0;
constexpr double kTrackEnd = kKnobRadius + 2.0; ///< Between the track's ends and the widget's edges, px
constexpr double kBeyond = 44.0;                ///< Length of the track beyond the present, px
constexpr double kGrip = 16.0; ///< Distance from the handle's middle at which it is grabbed, px
/// The handle is pulled so far beyond the present before anything grows, and so far for each step, px.
constexpr double kPull = 24.0;
constexpr double kPullPerStep = 6.0;

} // namespace

TimeSlider::TimeSlider(QWidget* parent) : QAbstractSlider(parent)
{
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
}

void TimeSlider::setHistory(int position, int length)
{
    const QSignalBlocker quiet(this);
    setRange(0, length);
    setPageStep(std::max(1, length / 20));
    setValue(position);
    update();
}

void TimeSlider::drop()
{
    if (!isSliderDown())
        return;
    const QSignalBlocker quiet(this);
    setSliderDown(false);
    update();
}

double TimeSlider::presentX() const
{
    return width() - kTrackEnd - kBeyond;
}

QPointF TimeSlider::placeOf(int position) const
{
    const double share = maximum() > 0 ? static_cast<double>(position) / maximum() : 1.0;
    return {kTrackEnd + share * (presentX() - kTrackEnd), height() / 2.0};
}

QPointF TimeSlider::handlePlace() const
{
    if (!isSliderDown())
        return placeOf(value());
    return {std::clamp(m_drag.place(), kTrackEnd, width() - kTrackEnd), height() / 2.0};
}

/// The position of a handle at @p x.
int TimeSlider::positionAt(double x) const
{
    const double pull = x - presentX();
    if (pull >= kPull)
        return maximum() + 1 + static_cast<int>((pull - kPull) / kPullPerStep);
    const double share = std::clamp((x - kTrackEnd) / (presentX() - kTrackEnd), 0.0, 1.0);
    return static_cast<int>(std::lround(share * maximum()));
}

/// A press beside the handle: a part of the way to @p x, never beyond the present.
void TimeSlider::step(double x)
{
    const int there = std::min(positionAt(x), maximum());
    setValue(value() < there ? std::min(value() + pageStep(), there) : std::max(value() - pageStep(), there));
}

void TimeSlider::sliderChange(SliderChange change)
{
    if (change == SliderValueChange && !signalsBlocked() && !isSliderDown()) {
        // Keys, and clicks beside the handle, are whole gestures.
        Q_EMIT moved(value());
        Q_EMIT letGo();
    }
    QAbstractSlider::sliderChange(change);
    update();
}

bool TimeSlider::event(QEvent* event)
{
    // Escape belongs to a drag under way.
    if (event->type() == QEvent::ShortcutOverride && isSliderDown() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QAbstractSlider::event(event);
}

void TimeSlider::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape || !isSliderDown())
        return QAbstractSlider::keyPressEvent(event);
    drop();
    Q_EMIT cancelled();
}

void TimeSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    const double x = event->position().x();
    const double handle = placeOf(value()).x();
    if (std::abs(x - handle) > kGrip)
        return step(x);
    // A pull beyond the present has no end.
    m_drag.begin(handle, x, kTrackEnd, std::numeric_limits<double>::max());
    m_position = value();
    m_hasMoved = false;
    setSliderDown(true);
    update();
}

void TimeSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (!isSliderDown())
        return;
    const QPointF pointer = event->position();
    m_drag.move(pointer.x(), std::abs(pointer.y() - height() / 2.0),
                event->modifiers().testFlag(Qt::ShiftModifier));
    update();
    const int position = positionAt(m_drag.place());
    if (std::exchange(m_position, position) == position)
        return;
    m_hasMoved = true;
    setValue(std::min(position, maximum()));
    Q_EMIT moved(position);
}

void TimeSlider::mouseReleaseEvent(QMouseEvent*)
{
    if (!isSliderDown())
        return;
    setSliderDown(false);
    update();
    if (m_hasMoved)
        Q_EMIT letGo();
}

void TimeSlider::wheelEvent(QWheelEvent* event)
{
    if (hasFocus())
        QAbstractSlider::wheelEvent(event);
    else
        event->ignore();
}

void TimeSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    const double present = presentX();
    const QPointF handle = handlePlace();
    painter.setPen(QPen(theme::kSunken, 4.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(kTrackEnd, middle), QPointF(present, middle));
    // The part in which the tree grows, and the mark of the present before it.
    painter.setPen(QPen(theme::kSunken, 4.0, Qt::DotLine, Qt::FlatCap));
    painter.drawLine(QPointF(present + kPull, middle), QPointF(width() - kTrackEnd, middle));
    if (isEnabled()) {
        painter.setPen(QPen(theme::kAccent, 4.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(kTrackEnd, middle), QPointF(std::min(handle.x(), present), middle));
    }
    painter.setPen(QPen(theme::kDimText, 2.0));
    painter.drawLine(QPointF(present, middle - 9.0), QPointF(present, middle + 9.0));
    painter.setPen(hasFocus() ? QPen(theme::kAccent, 2.0) : QPen(theme::kEdge, 1.0));
    const QColor knob = isEnabled() ? theme::inForce.knob : theme::kFaintText;
    painter.setBrush(underMouse() || isSliderDown() ? knob.lighter(110) : knob);
    painter.drawEllipse(handle, kKnobRadius - 0.5, kKnobRadius - 0.5);
}

} // namespace espalier

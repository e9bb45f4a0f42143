// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/PressureCurve.h"

#include "panels/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTabletEvent>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kCurveSteps = 48;
constexpr int kLongestTrail = 400;
constexpr double kWidest = 22.0; ///< Width of a trail at full pressure, px
/// A drag this close to an edge does not define the exponent; in shares of the field.
constexpr double kEdge = 0.04;
/// The factor of a key press.
constexpr double kStride = 1.1;

} // namespace

PressureCurve::PressureCurve(double softest, double firmest, QWidget* parent)
    : QWidget(parent), m_softest(softest), m_firmest(firmest)
{
    setAccessibleName(tr("Pressure curve"));
    setCursor(Qt::CrossCursor);
    setFocusPolicy(Qt::TabFocus);
    setMinimumSize(sizeHint());
}

void PressureCurve::setExponent(double exponent)
{
    m_exponent = std::clamp(exponent, m_softest, m_firmest);
    update();
}

QRectF PressureCurve::field() const
{
    return QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
}

void PressureCurve::dragTo(const QPointF& place)
{
    const QRectF box = field();
    const double x = std::clamp((place.x() - box.left()) / box.width(), kEdge, 1.0 - kEdge);
    const double y = std::clamp((box.bottom() - place.y()) / box.height(), kEdge, 1.0 - kEdge);
    setExponent(std::log(y) / std::log(x));
    Q_EMIT exponentEdited(m_exponent);
}

void PressureCurve::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        dragTo(event->position());
}

void PressureCurve::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        dragTo(event->position());
}

bool PressureCurve::event(QEvent* event)
{
    // Without modifiers these keys change the curve, also if they have a meaning for the tree.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && keyed(key->key())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

std::optional<double> PressureCurve::keyed(int key) const
{
    switch (key) {
    case Qt::Key_Up: // Softer: the same pressure has more effect
    case Qt::Key_Left:
        return m_exponent / kStride;
    case Qt::Key_Down:
    case Qt::Key_Right:
        return m_exponent * kStride;
    case Qt::Key_Home:
        return m_softest;
    case Qt::Key_End:
        return m_firmest;
    case Qt::Key_Delete:
        return 1.0;
    default:
        return {};
    }
}

void PressureCurve::keyPressEvent(QKeyEvent* event)
{
    const std::optional<double> exponent = keyed(event->key());
    if (!exponent)
        return QWidget::keyPressEvent(event);
    setExponent(*exponent);
    Q_EMIT exponentEdited(m_exponent);
}

void PressureCurve::tabletEvent(QTabletEvent* event)
{
    // A pen only tries the curve. The accepted event does not become a mouse event, which would drag it.
    event->accept();
    if (event->type() == QEvent::TabletPress)
        m_trail.clear();
    m_raw = event->type() == QEvent::TabletRelease ? 0.0 : std::clamp(event->pressure(), 0.0, 1.0);
    if (m_raw > 0.0 && m_trail.size() < kLongestTrail)
        m_trail.append({event->position(), kWidest * std::pow(m_raw, m_exponent)});
    update();
}

void PressureCurve::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = field();
    const auto at = [&box](double pressure, double share) {
        return QPointF(box.left() + pressure * box.width(), box.bottom() - share * box.height());
    };
    QPainterPath frame;
    frame.addRoundedRect(box, 8.0, 8.0);
    painter.fillPath(frame, theme::kSunken);
    painter.setClipPath(frame);
    painter.setPen(QPen(theme::kEdge, 1.0));
    for (const double share : {0.25, 0.5, 0.75}) {
        painter.drawLine(at(share, 0.0), at(share, 1.0));
        painter.drawLine(at(0.0, share), at(1.0, share));
    }
    painter.setPen(QPen(theme::kFaintText, 1.0, Qt::DotLine));
    painter.drawLine(at(0.0, 0.0), at(1.0, 1.0));

    QColor ink = theme::kDimText;
    ink.setAlpha(150);
    for (qsizetype i = 1; i < m_trail.size(); ++i) {
        painter.setPen(QPen(ink, std::max(0.5, m_trail[i].width), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(m_trail[i - 1].place, m_trail[i].place);
    }

    QPainterPath curve(at(0.0, 0.0));
    for (int i = 1; i <= kCurveSteps; ++i) {
        const double pressure = static_cast<double>(i) / kCurveSteps;
        curve.lineTo(at(pressure, std::pow(pressure, m_exponent)));
    }
    QPainterPath under = curve;
    under.lineTo(at(1.0, 0.0));
    under.closeSubpath();
    QColor fill = theme::kAccent;
    fill.setAlpha(40);
    painter.fillPath(under, fill);
    painter.setPen(QPen(theme::kAccent, 2.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(curve);

    painter.setClipping(false);
    painter.setPen(hasFocus() ? QPen(theme::kAccent, 2.0) : QPen(theme::kEdge, 1.0));
    painter.drawPath(frame);
    const double shown = m_raw > 0.0 ? m_raw : 0.5;
    painter.setPen(QPen(theme::kSunken, 2.0));
    painter.setBrush(m_raw > 0.0 ? theme::kHandle : theme::kAccent);
    painter.drawEllipse(at(shown, std::pow(shown, m_exponent)), 7.0, 7.0);
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/RotationStrip.h"

#include "panels/Theme.h"

#include <QPainter>

#include <cmath>
#include <numbers>
#include <utility>

namespace espalier {

namespace {

constexpr int kTicks = 72; ///< Of a full turn
constexpr int kLongEvery = 6;
constexpr double kReach = 0.46; ///< Half-width of the visible scale, as a share of the width

} // namespace

RotationStrip::RotationStrip(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("Rotation strip"));
}

void RotationStrip::setAzimuth(double azimuth)
{
    if (azimuth == m_azimuth)
        return;
    m_azimuth = azimuth;
    update();
}

void RotationStrip::setOverLight(bool light)
{
    if (std::exchange(m_isOverLight, light) != light)
        update();
}

/// The scale is the rim of a turntable, seen from the side.
void RotationStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = width() / 2.0;
    for (int tick = 0; tick < kTicks; ++tick) {
        const double angle = 2.0 * std::numbers::pi * tick / kTicks - m_azimuth;
        const double nearness = std::cos(angle);
        if (nearness <= 0.02)
            continue;
        const double x = middle + kReach * width() * std::sin(angle);
        QColor colour = m_isOverLight ? theme::kOverLight : theme::kBubbleText;
        colour.setAlphaF(static_cast<float>(0.55 * nearness));
        painter.setPen(QPen(colour, 1.2));
        const double length = tick % kLongEvery == 0 ? 0.44 : 0.22;
        painter.drawLine(QPointF(x, height() * (0.5 - length / 2.0)),
                         QPointF(x, height() * (0.5 + length / 2.0)));
    }
}

} // namespace espalier

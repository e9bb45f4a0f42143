// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Toggle.h"

#include "panels/Theme.h"

#include <QPainter>

namespace espalier {

namespace {
constexpr int kTrackWidth = 30;
constexpr int kTrackHeight = 16;
constexpr int kGap = 9;
} // namespace

Toggle::Toggle(const QString& text, QWidget* parent) : QCheckBox(text, parent)
{
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
}

QSize Toggle::sizeHint() const
{
    return {kTrackWidth + kGap + fontMetrics().horizontalAdvance(text()) + 2, theme::kTarget};
}

void Toggle::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(1.5, (height() - kTrackHeight) / 2.0 + 0.5, kTrackWidth - 2, kTrackHeight - 1);
    const double radius = track.height() / 2.0;
    painter.setPen(hasFocus() ? QPen(theme::kAccent, 1.5)
                              : QPen(isChecked() ? theme::kAccent : theme::kEdge, 1.0));
    painter.setBrush(isChecked() ? theme::kAccent : theme::kSunken);
    painter.drawRoundedRect(track, radius, radius);

    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0xee, 0xf1, 0xf5));
    const double x = isChecked() ? track.right() - radius : track.left() + radius;
    painter.drawEllipse(QPointF(x, track.center().y()), radius - 2.5, radius - 2.5);

    painter.setPen(underMouse() ? theme::kText : theme::kDimText);
    painter.drawText(rect().adjusted(kTrackWidth + kGap, 0, 0, 0),
                     Qt::AlignVCenter | Qt::AlignLeft | Qt::TextShowMnemonic, text());
}

} // namespace espalier

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/FineDrag.h"

#include <QAbstractSlider>

namespace espalier {

/// An upright, wedge-shaped slider for the brush's radius: wider where the radius is larger, finer where it
/// is small, and by the pointer (FineDrag).
class RadiusSlider : public QAbstractSlider {
    Q_OBJECT

public:
    explicit RadiusSlider(double maximum, QWidget* parent = nullptr);

    /// Sets the radius at the upper end, m. The radius may be larger.
    void setMaximumRadius(double metres);
    /// Radius in m.
    double radius() const { return m_radius; }
    /// Sets the radius; emits no signal.
    void setRadius(double metres);

    QSize sizeHint() const override { return {64, 212}; }
    QSize minimumSizeHint() const override { return {64, 84}; }

Q_SIGNALS:
    /// The user has moved the slider.
    void radiusEdited(double metres);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void sliderChange(SliderChange change) override;

private:
    void showRadius(double metres);
    double yOf(int position) const;
    void dragTo(double y);

    FineDrag m_drag;
    double m_maximum;
    double m_radius = 0.0;
};

} // namespace espalier

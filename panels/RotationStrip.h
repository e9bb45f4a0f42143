// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace espalier {

/// Shows where one hand rotates the tree while the other brushes (TreeSketch §3.1): a scale along the bottom
/// edge that turns with the view. The view beneath reads the fingers.
class RotationStrip : public QWidget {
    Q_OBJECT

public:
    explicit RotationStrip(QWidget* parent = nullptr);

    /// Of the view, rad.
    void setAzimuth(double azimuth);
    /// Whether what it lies over is light.
    void setOverLight(bool light);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_azimuth = 0.0;
    bool m_isOverLight = false;
};

} // namespace espalier
